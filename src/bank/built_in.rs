//! The banks that the program brings along, and their texts in other languages.

/// A file of a bank: id, file, text.
type OfBank = (&'static str, &'static str, &'static str);

/// Banks in the program.
pub const BUILT_IN: &[OfBank] = &[
    (
        "wheels-on-inclines",
        "banks/wheels-on-inclines.yaml",
        include_str!("../../banks/wheels-on-inclines.yaml"),
    ),
    (
        "hoists-and-pulleys",
        "banks/hoists-and-pulleys.yaml",
        include_str!("../../banks/hoists-and-pulleys.yaml"),
    ),
    ("slip-and-roll", "banks/slip-and-roll.yaml", include_str!("../../banks/slip-and-roll.yaml")),
    ("pinned-bodies", "banks/pinned-bodies.yaml", include_str!("../../banks/pinned-bodies.yaml")),
    ("rods-and-linkages", "banks/rods-and-linkages.yaml", include_str!("../../banks/rods-and-linkages.yaml")),
    ("more-wheels", "banks/more-wheels.yaml", include_str!("../../banks/more-wheels.yaml")),
];

/// Names of scenes, with their texts.
macro_rules! scenes {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../../templates/new/", $name, ".yaml")))),*]
    };
}

/// Banks of one scene to begin a bank of one's own with: name, text. The first line of the text says what it is.
pub const SCENES: &[(&str, &str)] = scenes![
    "pulled-wheel",
    "rolling-down",
    "wheel-and-spring",
    "block-pulley-wheel",
    "stepped-drum",
    "yo-yo",
    "atwood",
    "bowling-ball",
    "block-on-incline",
    "falling-rod",
    "compound-pendulum",
    "kinetic-energy",
];

/// Texts of built-in banks in other languages, by code.
pub const TRANSLATED: &[(&str, &[OfBank])] = &[(
    "de",
    &[
        (
            "wheels-on-inclines",
            "templates/de/banks/wheels-on-inclines.yaml",
            include_str!("../../templates/de/banks/wheels-on-inclines.yaml"),
        ),
        (
            "hoists-and-pulleys",
            "templates/de/banks/hoists-and-pulleys.yaml",
            include_str!("../../templates/de/banks/hoists-and-pulleys.yaml"),
        ),
        (
            "slip-and-roll",
            "templates/de/banks/slip-and-roll.yaml",
            include_str!("../../templates/de/banks/slip-and-roll.yaml"),
        ),
        (
            "pinned-bodies",
            "templates/de/banks/pinned-bodies.yaml",
            include_str!("../../templates/de/banks/pinned-bodies.yaml"),
        ),
        (
            "rods-and-linkages",
            "templates/de/banks/rods-and-linkages.yaml",
            include_str!("../../templates/de/banks/rods-and-linkages.yaml"),
        ),
        (
            "more-wheels",
            "templates/de/banks/more-wheels.yaml",
            include_str!("../../templates/de/banks/more-wheels.yaml"),
        ),
    ],
)];
