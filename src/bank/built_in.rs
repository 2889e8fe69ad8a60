//! The banks that the program brings along, and their texts in other languages.

/// A file of a bank: id, file, text.
type OfBank = (&'static str, &'static str, &'static str);

/// The banks below a folder.
macro_rules! banks {
    ($folder:literal) => {
        banks![$folder: "wheels-on-inclines", "hoists-and-pulleys", "slip-and-roll", "pinned-bodies", "rods-and-linkages", "more-wheels"]
    };
    ($folder:literal: $($id:literal),*) => {
        &[$(($id, concat!($folder, $id, ".yaml"), include_str!(concat!("../../", $folder, $id, ".yaml")))),*]
    };
}

/// Banks in the program.
pub const BUILT_IN: &[OfBank] = banks!("banks/");

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
pub const TRANSLATED: &[(&str, &[OfBank])] = &[("de", banks!("templates/de/banks/"))];
