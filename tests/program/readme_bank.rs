//! The bank examples of README and manual: whole banks load without a finding, fragments without one of their own.
use slipstick::bank::load;
use slipstick::finding::Findings;
use slipstick::manual;

const README: &str = include_str!("../../README.md");

/// Every example in YAML.
pub fn blocks() -> Vec<&'static str> {
    let texts = std::iter::once(README).chain(manual::TOPICS.iter().map(|t| t.text));
    texts.flat_map(|text| text.split("```yaml\n").skip(1)).filter_map(|b| b.split("```").next()).collect()
}

fn findings(text: &str) -> Findings {
    load::scenes_only(text, "bank.md").err().unwrap_or_default()
}

/// A bank around one fragment.
fn around(kind: &str, item: &str) -> String {
    let data = [
        ("m", "kg"),
        ("R", "m"),
        ("r", "m"),
        ("k", "m"),
        ("theta", "deg"),
        ("P", "N"),
        ("ks", "N/m"),
        ("x0", "m"),
        ("mu_s", "1"),
        ("mu_k", "1"),
        ("mu", "1"),
        ("d", "m"),
        ("W", "N"),
        ("M", "kg"),
        ("I", "kg*m^2"),
        ("b", "m"),
        ("m1", "kg"),
        ("R1", "m"),
        ("m2", "kg"),
        ("R2", "m"),
        ("m_A", "kg"),
        ("x_A", "m"),
        ("y_A", "m"),
        ("m_B", "kg"),
        ("x_B", "m"),
        ("y_B", "m"),
        ("s", "m"),
        ("t1", "s"),
        ("v1", "m/s"),
    ];
    let data: String = data
        .iter()
        .map(|(s, u)| format!("      {s}: {{name: {s}, unit: \"{u}\", draw: always 0.4}}\n"))
        .collect();
    let indent = |text: &str, by: &str| text.lines().map(|l| format!("{by}{l}\n")).collect::<String>();
    let mut bodies = "        wheel: {mass: m, radius of gyration: k, radii: {rim: R, hub: r}, moves: along incline}\n        \
                      pulley: {mass: M, shape: {disc: b}, radii: {rim: b}, moves: about a fixed axle}\n        \
                      drum: {mass: M, shape: {disc: b}, radii: {rim: b}, moves: about a fixed axle}\n        \
                      block: {mass: m, moves: along incline}\n"
        .to_owned();
    let mut ties = "        - rolls: {body: wheel, on its: hub}\n".to_owned();
    let mut end = "{travel: {of: wheel, by: d}}".to_owned();
    let mut start = "at rest";
    let mut rest = String::new();
    match kind {
        "bodies" => bodies += &format!("        another_{item}\n"),
        "ties" => {
            bodies += "        yoyo: {mass: m, radius of gyration: k, radii: {hub: r}, moves: vertically, positive: down}\n        \
                       plank: {mass: m, moves: along incline}\n        \
                       front: {mass: m, shape: {disc: R}, moves: along incline}\n        \
                       rear: {mass: m, shape: {disc: R}, moves: along incline}\n";
            ties = indent(item, "        ");
        }
        "ends" if item.contains("rolling") => {
            end = item.trim_start_matches("- ").to_owned();
            ties = "        - slips: {body: wheel, on its: hub, mu_s: mu_s, mu_k: mu_k}\n".to_owned();
            start = "{wheel: {speed: v1, spin: 3 rad/s}}";
        }
        "forces" => rest = format!("      forces:\n{}", indent(item, "        ")),
        "ends" => end = item.trim_start_matches("- ").to_owned(),
        "bounds" | "cases" => rest = format!("    {kind}:\n{}", indent(item, "      ")),
        _ => panic!("no fragment of kind {kind}"),
    }
    format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data:\n{data}    scene:\n      surfaces: {{incline: {{slope: theta}}}}\n      bodies:\n{bodies}      ties:\n{ties}      start: {start}\n      end: {end}\n{rest}    questions:\n      wheel.v: {{ask: v, unit: m/s}}\n    statement: s\n"
    )
}

/// A bank around a scene with a pinned body, or of bodies that are joined in the plane.
fn swinging(scene: &str) -> String {
    let data = [
        ("m", "kg"),
        ("L", "m"),
        ("R", "m"),
        ("r", "m"),
        ("k", "m"),
        ("h", "m"),
        ("P", "N"),
        ("M", "N*m"),
        ("b", "m"),
        ("I_G", "kg*m^2"),
        ("mu", "1"),
        ("J", "N*s"),
        ("x_A", "m"),
        ("y_A", "m"),
        ("ks", "N/m"),
        ("l0", "m"),
        ("kt", "N*m/rad"),
        ("a0", "m/s^2"),
        ("ma", "kg"),
        ("v0", "m/s"),
        ("phi0", "deg"),
        ("w0", "rad/s"),
        ("phi1", "deg"),
    ];
    // Data that a scene does not use are a finding.
    let told: String = scene.lines().map(|l| l.split(" #").next().unwrap_or(l).to_owned() + "\n").collect();
    let words: Vec<&str> = told.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let data: String = data
        .iter()
        .filter(|(s, _)| words.contains(s))
        .map(|(s, u)| format!("      {s}: {{name: {s}, unit: \"{u}\", draw: always 0.4}}\n"))
        .collect();
    // With several bodies a quantity has its body before it.
    let bodies: Vec<&str> = scene.lines().skip(2).take_while(|l| l.starts_with(' ')).collect();
    let first = bodies.first().and_then(|l| l.trim().split_once(':')).map_or("", |(body, _)| body);
    let quantity = if scene.contains("end: equilibrium") { "phi" } else { "omega" };
    let asked = if bodies.len() > 1 { format!("{first}.{quantity}") } else { quantity.to_owned() };
    let scene: String = scene.lines().skip(1).map(|l| format!("      {l}\n")).collect();
    format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data:\n{data}    scene:\n{scene}    questions: {{omega: {{quantity: {asked}, ask: omega}}}}\n    statement: s\n"
    )
}

#[test]
fn the_examples_of_readme_and_manual_are_banks() {
    let (mut whole, mut parts) = (0, 0);
    for block in blocks() {
        let Some(kind) = block.strip_prefix("# fragment: ").and_then(|b| b.lines().next()) else {
            let found = findings(block);
            assert!(found.is_empty(), "{found:#?}\n{block}");
            whole += 1;
            continue;
        };
        if kind == "scene" {
            let found = findings(&swinging(block));
            assert!(found.is_empty(), "{found:#?}\n{block}");
            parts += 1;
            continue;
        }
        for item in block.lines().skip(1) {
            let item = item.split("   #").next().unwrap_or(item).trim_end();
            let text = around(kind, item);
            let place = match kind {
                "bodies" | "ties" | "forces" => format!("scene.{kind}"),
                "ends" => "scene.end".to_owned(),
                other => format!("p.{other}"),
            };
            let own: Vec<String> = findings(&text)
                .iter()
                .filter(|f| f.field.contains(&place))
                .map(ToString::to_string)
                .collect();
            assert!(own.is_empty(), "{item}\n{}", own.join("\n"));
            parts += 1;
        }
    }
    assert!(whole >= 1 && parts >= 20, "{whole} banks and {parts} fragments");
}

#[test]
fn a_wrong_fragment_would_be_seen() {
    let text = around("ties", "- rolls: {body: wheel, on its: hob}");
    assert!(findings(&text).iter().any(|f| f.field.contains("scene.ties")));
}
