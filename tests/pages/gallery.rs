//! The page on which an instructor looks through a bank: what is in it, and that its numbers are those of `lint`.
use crate::support::program;
use slipstick::cli::tell::Exit;

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

/// Text between tags, with single spaces.
fn text_of(html: &str) -> String {
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
    let page = text_of(&std::fs::read_to_string(&file).unwrap());
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
    let page = text_of(&std::fs::read_to_string(&file).unwrap());
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

#[test]
fn a_refused_draw_is_shown_with_figure_and_reason() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let text = run(&["new", "yo-yo"]).1;
    // A problem that no draw meets: the page is there all the same, and the command fails.
    std::fs::write(path("up.yaml"), text.replace("regimes: [moves_down]", "regimes: [moves_up]")).unwrap();
    let (exit, out, err) =
        run(&["gallery", &path("up.yaml"), "--out", &path("up.html"), "--variants", "3", "--seeds", "5"]);
    assert_eq!(exit, Exit::Faulty);
    assert!(out.contains("where so many could be drawn"), "{out}");
    assert!(err.contains("regime: 10000 of 10000 move down (`regimes`: moves_up)"), "{err}");
    let page = std::fs::read_to_string(path("up.html")).unwrap();
    let refused = page.split("<ul class=\"cards refused\">").nth(1).unwrap().split("</ul>").next().unwrap();
    assert_eq!(refused.matches("<figure><svg").count(), 1);
    assert!(text_of(refused).contains("regime: 1 of 1 move down (`regimes`: moves_up)"), "{refused}");
    assert!(refused.contains("class=\"data\"") && !refused.contains("<table>"));
    // One whose rules some draws break: variants, and a refused draw for each rule.
    let bounds = "r / k: {max: 0.8}";
    assert!(text.contains(bounds));
    let text = text.replace(bounds, "r / k: {max: 0.3}\n      v: {max: 1 m/s}");
    std::fs::write(path("some.yaml"), text).unwrap();
    let (_, _, err) =
        run(&["gallery", &path("some.yaml"), "--out", &path("some.html"), "--variants", "2", "--seeds", "5"]);
    let page = std::fs::read_to_string(path("some.html")).unwrap_or_else(|e| panic!("{e}: {err}"));
    let refused = page.split("<ul class=\"cards refused\">").nth(1).unwrap().split("</ul>").next().unwrap();
    let told = text_of(refused);
    assert!(told.contains("bound v: 1.") && told.contains("bound r / k: 0."), "{told}");
    let cards = refused.matches("<li>").count();
    assert!((2..=4).contains(&cards), "{cards} cards: {told}");
    assert_eq!(refused.matches("<figure><svg").count(), cards);
}

#[test]
fn a_page_that_is_watched_is_drawn_again_when_the_bank_is_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let text = run(&["new", "atwood"]).1;
    std::fs::write(path("b.yaml"), &text).unwrap();
    let out = std::fs::File::create(path("out.txt")).unwrap();
    let err = std::fs::File::create(path("err.txt")).unwrap();
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_slipstick"))
        .args(["gallery", "b.yaml", "--out", "g.html", "--watch", "--variants", "1", "--seeds", "5"])
        .current_dir(folder.path())
        .stdout(out)
        .stderr(err)
        .spawn()
        .unwrap();
    let read = |name: &str| std::fs::read_to_string(path(name)).unwrap_or_default();
    // The text of a file, once it holds these words; whatever it holds after two minutes.
    let wait = |name: &str, words: &str| {
        for _ in 0..600 {
            if read(name).contains(words) {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(200));
        }
        read(name)
    };
    let drawn = wait("out.txt", "waiting until b.yaml is saved");
    let first = read("g.html");
    std::fs::write(path("b.yaml"), text.replace("title: My problems", "titel: My problems")).unwrap();
    let fault = wait("err.txt", "unknown field `titel`");
    let kept = read("g.html");
    std::fs::write(path("b.yaml"), text.replace("title: My problems", "title: Others")).unwrap();
    let second = wait("g.html", "Gallery: Others");
    let running = child.try_wait().unwrap().is_none();
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(drawn.contains("1 problem of 1 variant each"), "{drawn}");
    assert!(fault.contains("unknown field `titel`"), "{fault}");
    assert!(first.contains("Gallery: My problems") && kept == first);
    assert!(second.contains("Gallery: Others") && running);
    let (exit, _, err) = run(&["gallery", "slip-and-roll", "--out", "x.html", "--watch"]);
    assert!(exit == Exit::Faulty && err.contains("is no file") && err.contains("slipstick new"), "{err}");
}
