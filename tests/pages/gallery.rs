//! The page on which an instructor looks through a bank: what is in it, and that its numbers are those of `lint`.
use crate::support::program;
use slipstick::cli::tell::Exit;

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

/// Text between tags, with single spaces.
fn text(html: &str) -> String {
    let mut out = String::new();
    for piece in html.split('<') {
        out.push(' ');
        out.push_str(piece.split_once('>').map_or(piece, |(_, text)| text));
    }
    let plain = out.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    plain.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_variant_has_figure_data_and_answers() {
    let folder = tempfile::tempdir().unwrap();
    for (bank, problems) in [("wheels-on-inclines", 4), ("hoists-and-pulleys", 0), ("pinned-bodies", 0)] {
        let file = folder.path().join(format!("{bank}.html")).display().to_string();
        let (exit, out, err) = run(&["gallery", bank, "--out", &file, "--variants", "3", "--seeds", "40"]);
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
        assert!(out.contains("of 3 variants each"), "{out}");
        let html = std::fs::read_to_string(&file).unwrap();
        let sections = html.matches("<section id=").count();
        assert!(sections > 1 && (problems == 0 || sections == problems));
        let cards = html.split("<ul class=\"cards\">").skip(1).map(|c| c.split("</ul>").next().unwrap());
        for cards in cards {
            assert_eq!(cards.matches("<figure><svg").count(), 3);
            assert_eq!(cards.matches("class=\"data\"").count(), 3);
            assert!(cards.matches("<th scope=\"row\">").count() >= 6);
        }
        // Ids are unique, and nothing is asked of the network.
        let mut ids: Vec<&str> =
            html.split(" id=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
        let count = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), count);
        for word in ["http://", "https://", "src=", "{{"] {
            let found = html.match_indices(word).find(|(i, _)| !html[*i..].starts_with("http://www.w3.org/"));
            assert_eq!(found, None, "{word}");
        }
        // The figures say in words what they show.
        assert_eq!(html.matches("role=\"img\"").count(), html.matches("<desc").count());
    }
}

#[test]
fn its_tables_are_those_of_lint() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("g.html").display().to_string();
    let (_, lint, _) = run(&["lint", "slip-and-roll", "--seeds", "60"]);
    let (exit, _, err) =
        run(&["gallery", "slip-and-roll", "--out", &file, "--variants", "1", "--seeds", "60"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    let page = text(&std::fs::read_to_string(&file).unwrap());
    let mut rows = 0;
    for line in lint.lines().filter(|l| l.starts_with(' ')) {
        let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
        if let Some(refused) = line.strip_prefix("refused ") {
            let (count, rule) = refused.split_once(' ').unwrap();
            assert!(page.contains(&format!("{rule} {count} ")), "{line} in\n{page}");
        } else if let Some(note) = line.strip_prefix("note: ") {
            assert!(page.contains(note), "{note}");
        } else if line.contains(" alone: ") {
            continue;
        } else {
            assert!(page.contains(&line), "{line} in\n{page}");
        }
        rows += 1;
    }
    assert!(rows > 12, "{rows} rows");
    assert!(page.contains(lint.lines().find(|l| l.starts_with("Chance that")).unwrap()));
}

#[test]
fn a_gallery_in_german_and_of_chosen_problems() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("g.html").display().to_string();
    let chosen =
        ["gallery", "wheels-on-inclines", "--out", &file, "--variants", "2", "--seeds", "5", "--problems"];
    let run_with = |more: &[&str]| run(&[&chosen[..], more].concat());
    let (exit, _, err) = run_with(&["pulled-rolling", "--language", "de"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    let page = text(&std::fs::read_to_string(&file).unwrap());
    for word in ["Galerie: Räder auf schiefen Ebenen", "Variante 2", "Ziehungen"] {
        assert!(page.contains(word), "{word} in\n{page}");
    }
    assert!(!page.contains("spring-released"));
    // A file that is there stays, unless it may be replaced.
    let (exit, _, err) = run_with(&["pulled-rolling"]);
    assert!(exit == Exit::Faulty && err.contains("is there already") && err.contains("--force"), "{err}");
    let (exit, _, err) = run_with(&["pulled-rolling", "--force"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    let (exit, _, err) = run_with(&["pulled-roling", "--force"]);
    assert!(exit == Exit::Faulty && err.contains("pulled-rolling"), "{err}");
    let (exit, _, err) =
        run(&["gallery", "wheels-on-inclines", "--out", &file, "--variants", "0", "--force"]);
    assert!(exit == Exit::Faulty && err.contains("from 1 to"), "{err}");
}
