//! Texts of a bank that mean harm, or that a slip of the pen made so: templates that build without end, HTML and links that act
//! in a student's browser, LaTeX that acts in an instructor's terminal. And that honest ones still come through as before.
//!
//! Earlier tests gave templates that cannot be read and foreign names with odd signs; none gave a template that can be read
//! and never ends, and none looked at what a statement itself brings into a page.
use crate::support::program;
use scraper::{ElementRef, Html};
use slipstick::cli::tell::Exit;
use slipstick::sheet::document::{Document, Dropped, Head, dropped};
use slipstick::sheet::html::{Converter, PlaceInPage};
use slipstick::sheet::{formula, html, tex, typst};
use slipstick::template::{Templates, View};
use slipstick::words::Words;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

fn run(args: &[&str]) -> (Exit, String, String) {
    program::run(args).parts()
}

/// A bank with one problem; the lines are appended to its statement, the question is as given.
fn bank(statement: &str, ask: &str, title: &str) -> String {
    let statement =
        format!("The mass is {{{{ m }}}} and the distance {{{{ d }}}}; {{{{ g }}}}.\n{statement}");
    program::sliding(title, &format!("v: {{ask: {ask:?}, unit: m/s}}"), &statement)
}

/// Templates that build, go through or write without end, each in a way of its own.
fn bombs() -> Vec<(&'static str, String)> {
    let repeated = |begin: &str, again: &str, times: usize| format!("{begin}{}", again.repeat(times));
    let long = "a".repeat(30_000);
    vec![
        (
            "doubled in a loop",
            "{% set_global x = 'ab' %}{% for i in range(end=40) %}{% set_global x = x ~ x %}{% endfor %}".to_owned(),
        ),
        ("doubled in a row", repeated("{% set x = 'ab' %}", "{% set x = x ~ x %}", 40)),
        (
            "loops that write nothing",
            "{% for i in range(end=30000) %}{% for j in range(end=30000) %}{% for k in range(end=30000) %}{% endfor %}{% endfor %}{% endfor %}"
                .to_owned(),
        ),
        (
            "the largest ranges",
            "{% for i in range(end=100000) %}{% for j in range(end=100000) %}x{% endfor %}{% endfor %}".to_owned(),
        ),
        ("a range backwards", "{{ range(start=9000000000, end=0, step_by=-1) | length }}".to_owned()),
        (
            "loops over letters",
            format!(
                "{{% set x = '{}' %}}{}{}",
                "abc".repeat(60),
                (0..8).map(|i| format!("{{% for c{i} in x %}}")).collect::<String>(),
                "{% endfor %}".repeat(8)
            ),
        ),
        ("many ranges at once", format!("{{{{ [{}0] | length }}}}", "range(end=100000), ".repeat(200))),
        ("caught and doubled", repeated("{% set x = 'abcd' %}", "{% set x %}{{ x }}{{ x }}{% endset %}", 40)),
        (
            "caught in a loop",
            "{% set_global x = 'abcd' %}{% for i in range(end=40) %}{% set_global x %}{{ x }}{{ x }}{% endset %}{% endfor %}"
                .to_owned(),
        ),
        ("lists of lists", repeated("{% set x = [1] %}", "{% set x = [x, x] %}", 60) + "{{ x }}"),
        ("lists spread", repeated("{% set x = [1] %}", "{% set x = [...x, ...x] %}", 40)),
        ("maps of maps", repeated("{% set x = {'a': 1} %}", "{% set x = {'a': x, 'b': x} %}", 60) + "{{ x | length }}"),
        (
            "replaced again and again",
            format!("{{{{ 'aaaaaaaa'{} }}}}", " | replace(from='a', to='aaaaaaaaaaaaaaaaaaaaaaaa')".repeat(12)),
        ),
        (
            "replaced by itself",
            repeated("{% set x = 'a' %}", "{% set x = x | replace(from='', to=x) %}", 8),
        ),
        (
            "split and joined",
            format!("{{{{ 'aaaaaaaaaaaaaa'{} }}}}", " | split(pat='') | join(sep='aaaaaaaaaaaaaaaaaa')".repeat(12)),
        ),
        (
            "indented",
            format!(
                "{{% set x = '{}' | replace(from='-', to='\\n') %}}{{{{ x{} }}}}",
                "a-".repeat(900),
                " | indent(width=1000, blank=true) | replace(from=' ', to='\\n')".repeat(4)
            ),
        ),
        (
            "filters over a part",
            format!(
                "{}a{}",
                "{% filter replace(from='a', to='aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa') %}".repeat(8),
                "{% endfilter %}".repeat(8)
            ),
        ),
        (
            "a list made by for",
            "{% set x = [[1 for j in range(end=100000)] for i in range(end=100000)] %}".to_owned(),
        ),
        (
            "components within components",
            "{% component b(n: int = 0) %}{% if n < 19 %}{{<b n={n+1} />}}{{<b n={n+1} />}}{{<b n={n+1} />}}{% endif %}{% endcomponent %}{{<b n={0} />}}"
                .to_owned(),
        ),
        ("all that is known, in itself", repeated("{% set x = 1 %}", "{% set x = __tera_context %}", 60)),
        ("branches without end", repeated("{% if m == 'a' %}", "{% elif m == 'b' %}", 12_000) + "{% endif %}"),
        ("brackets without end", format!("{{{{ {}m{} }}}}", "(".repeat(5000), ")".repeat(5000))),
        ("conditions without end", format!("{}{}", "{% if m %}".repeat(5000), "{% endif %}".repeat(5000))),
        (
            "long texts put together at once",
            format!("{{% set x = '{long}' %}}{{{{ [{}0] | length }}}}", "'' ~ x, ".repeat(120)),
        ),
        ("a long text many times", format!("{{% set x = '{long}' %}}{}", "{{ x }}".repeat(3000))),
        (
            "long texts compared",
            format!("{{% set x = '{long}' %}}{{% for i in range(end=9000) %}}{{% if x ~ 'a' == x ~ 'b' %}}{{% endif %}}{{% endfor %}}"),
        ),
        ("unique items", "{% set x = range(end=30000) | unique | length %}".to_owned()),
        ("a text that is too long", "x".repeat(300_000)),
        ("a formula that repeats itself", r"$\def\x{\x\x}\x$".to_owned()),
        ("a formula that doubles", r"$\def\a{xx}\def\b{\a\a}\newcommand{\c}{\b\b\b}\c$".to_owned()),
        ("a formula of groups", format!("${}x{}$", "{ ".repeat(4000), " }".repeat(4000))),
        ("a formula of roots", format!("${}x$", r"\sqrt".repeat(20_000))),
    ]
}

/// Each bomb in a process of its own with a gigabyte of addresses: it ends soon, with code 2 and a place, in statements, in
/// questions and in files of templates.
#[cfg(unix)]
#[test]
fn a_template_cannot_exhaust_memory_or_time() {
    let room = tempfile::tempdir().unwrap();
    fs::write(room.path().join("r.csv"), "student,name\ns1,A\n").unwrap();
    let bounded = |folder: &Path, args: &str| {
        let begin = Instant::now();
        let command =
            format!("ulimit -v 1000000; exec \"$0\" generate {args} --seed 1 --threads 1 --out out");
        let ran = Command::new("sh")
            .args(["-c", &command, env!("CARGO_BIN_EXE_slipstick")])
            .current_dir(folder)
            .output()
            .unwrap();
        let err = String::from_utf8_lossy(&ran.stderr).into_owned();
        assert!(begin.elapsed() < Duration::from_secs(60), "{args}: {:?}", begin.elapsed());
        (ran.status.code(), err)
    };
    let judge = |name: &str, (code, err): (Option<i32>, String), place: &str, field: &str| {
        let shown: String = err.chars().take(600).collect();
        assert_eq!(code, Some(2), "{name}: {shown}");
        assert!(err.contains(place) && err.contains(field), "{name}: {shown}");
        assert!(err.len() < 3000, "{name}: {} characters of message", err.len());
        assert!(!room.path().join("out").exists(), "{name}: half written");
    };
    let statement = "problems.slide";
    for (name, bomb) in bombs() {
        fs::write(room.path().join("b.yaml"), bank(&bomb, "the speed", "A block")).unwrap();
        let place = if name.starts_with("a formula") { "problems.slide: formula" } else { "b.yaml:20:" };
        judge(name, bounded(room.path(), "b.yaml --roster r.csv"), place, statement);
    }
    // In a question, and in files that stand in the place of built-in templates.
    let (_, bomb) = &bombs()[0];
    fs::write(room.path().join("b.yaml"), bank("", &format!("the speed {bomb}"), "A block")).unwrap();
    judge(
        "ask",
        bounded(room.path(), "b.yaml --roster r.csv"),
        "b.yaml:18:",
        "problems.slide.questions.v.ask",
    );
    fs::write(room.path().join("b.yaml"), bank("", "the speed", "A block")).unwrap();
    for file in ["questions.md", "sheet.md", "sheet.html", "booklet.html", "style.html", "key-table.md"] {
        let mine = room.path().join("mine");
        fs::create_dir_all(&mine).unwrap();
        fs::write(mine.join(file), format!("first line\nand {bomb}")).unwrap();
        let ran = bounded(room.path(), "b.yaml --roster r.csv --templates mine");
        judge(file, ran, &format!("mine/{file}:2:"), "template:");
        fs::remove_dir_all(&mine).unwrap();
    }
}

/// Every part of the language that is offered gives what it gave without a meter, and a fault keeps its line and column.
#[test]
fn honest_templates_come_through() {
    let render = |text: &str| {
        let own = [("mine.md".to_owned(), "mine.md".to_owned(), text.to_owned())];
        let templates = Templates::new("en", &own).map_err(|f| f[0].to_string())?;
        let mut view = View::new();
        view.text("m", "2 kg");
        view.foreign("name", "a*b");
        let items = ["one", "two", "three"].map(slipstick::template::finished);
        view.value("items", slipstick::template::list(items.to_vec()));
        let mut out = Vec::new();
        templates.render("mine.md", &view, &mut out).map_err(|f| f.to_string())?;
        Ok::<_, String>(String::from_utf8(out).unwrap())
    };
    for (text, expected) in [
        ("{{ m }}, {{ name }}", "2 kg, a\\*b"),
        ("{% set a = m ~ ' and ' ~ name %}{{ a }}", "2 kg and a\\*b"),
        ("{% for i in items -%} {{ loop.index }}{{ i }} {%- endfor %}", "1one2two3three"),
        ("{% for i in range(end=3) %}{{ i }}{% else %}none{% endfor %}", "012"),
        ("{% for i in range(start=5, end=1, step_by=-2) %}{{ i }}{% endfor %}", "53"),
        (
            "{% for i in range(end=50) %}{% for j in range(end=50) %}.{% endfor %}{% endfor %}",
            &".".repeat(2500),
        ),
        ("{% for k, v in {'a': 1, 'b': 2} %}{{ k }}{{ v }}{% endfor %}", "a1b2"),
        ("{% for i in items %}{% if i == 'two' %}{% continue %}{% endif %}{{ i }}{% endfor %}", "onethree"),
        ("{{ m | replace(from='kg', to='t') | upper }}", "2 T"),
        ("{{ items | join(sep='-') }} {{ [1, 2] | join }}", "one-two-three 12"),
        ("{{ name | upper }} {{ name | replace(from='a', to='*') }}", "A\\*B \\*\\*b"),
        ("{% set x %}<{{ m }}>{% endset %}{{ x }}{{ x | length }}", "<2 kg>6"),
        ("{% filter upper | replace(from='B', to='c') %}ab{% endfilter %}", "Ac"),
        ("{% set l = [[1, 2], [3]] %}{{ l[0][1] }}{{ l[1] | length }}", "21"),
        ("{% if m is containing(pat='kg') and not ('z' in m) %}yes{% elif m %}no{% endif %}", "yes"),
        ("{% raw %}{{ x ~ }}{% endraw %}{# {{ x | #}{{ 'q' if m else 'r' }}", "{{ x ~ }}q"),
        ("{{ -1.5 | abs }} {{ 2 + 3 * 4 }} {{ 'a' ~ 1 ~ [1, 2] }}", "1.5 14 a1\\[1, 2\\]"),
        ("{{ nowhere | default(value='d') }} {{ nowhere is defined }}", "d false"),
        ("{{ 'x\\ny' | indent }} {{ \"}}\" }} {{ '%}' ~ \"~|\" }}", "x     y \\}\\} %\\}\\~\\|"),
        ("{{- m -}}  x {%- if m %} y{% endif -%}  z", "2 kgx yz"),
        ("{% set_global n = 0 %}{% for i in items %}{% set_global n = n + 1 %}{% endfor %}{{ n }}", "3"),
    ] {
        assert_eq!(render(text).as_deref(), Ok(expected), "{text}");
    }
    // The place is that of the text as it was written: where the fault begins, or right behind the value that is at fault.
    let pointed = |text: &str| {
        let fault = render(text).expect_err(text);
        let mut place = fault.split(':').skip(1).map(|n| n.parse::<usize>().unwrap_or(0));
        let (line, column) = (place.next().unwrap(), place.next().unwrap());
        let line = text.lines().nth(line - 1).unwrap_or_default();
        line.chars().skip(column - 1).take(4).collect::<String>()
    };
    let found: Vec<String> = [
        "{{ [1] | join ~ m ~ (m | nth(n=1)) }}".to_owned(),
        "a\n{% set x = m ~ 'b' %}ü{{ x ~ 'c' }}{{ x | int }}".to_owned(),
        "{% for i in [m, m] %}\n{{ i ~ i }}{{ i ~ nowhere.y }}{% endfor %}".to_owned(),
        "{% set x = 1 %}{{ nowhere }}".to_owned(),
        "{{ m ~ }}".to_owned(),
        "a{% block a %}{% endblock %}".to_owned(),
        format!("{{% set x = 'ab' %}}{}", "{% set x = x ~ x %}".repeat(30)),
    ]
    .iter()
    .map(|text| pointed(text))
    .collect();
    assert_eq!(found, ["| nt", "int ", "nowh", " }}", "}}", "{% b", " %}{"]);
}

/// What has acted in some browser or viewer once, as a statement would hold it.
const ACTIVE: &[&str] = &[
    "<script>alert(1)</script>",
    "a <script>alert(1)</script> b",
    "<SCRIPT SRC=http://x.example/x.js></SCRIPT>",
    "<scr<script>ipt>alert(1)</scr</script>ipt>",
    "<img src=x onerror=alert(1)>",
    "<img src=\"http://x.example/pixel.gif\">",
    "<svg onload=alert(1)>",
    "<svg><script>alert(1)</script></svg>",
    "<math><mtext><img src=x onerror=alert(1)></mtext></math>",
    "<iframe src=\"javascript:alert(1)\"></iframe>",
    "<object data=\"data:text/html,<script>alert(1)</script>\"></object>",
    "<embed src=\"http://x.example/x.swf\">",
    "<link rel=stylesheet href=http://x.example/x.css>",
    "<style>@import 'http://x.example/x.css';</style>",
    "<style>body{background:url(http://x.example/x)}</style>",
    "<meta http-equiv=refresh content=\"0;url=http://x.example\">",
    "<base href=\"http://x.example/\">",
    "<form action=http://x.example><input name=q></form>",
    "<a href=\"javascript:alert(1)\">x</a>",
    "<body onload=alert(1)>",
    "<div style=\"background:url(http://x.example)\">x</div>",
    "<details open ontoggle=alert(1)>",
    "<video><source onerror=alert(1)></video>",
    "<input autofocus onfocus=alert(1)>",
    "<!-- --><script>alert(1)</script>",
    "<!-- answer --><script>alert(1)</script>",
    "<br onclick=alert(1)>",
    "<![CDATA[<script>alert(1)</script>]]>",
    "<?php echo 1 ?>",
    "</main></body><script>alert(1)</script>",
    "[x](javascript:alert(1))",
    "[x](JaVaScRiPt:alert(1))",
    "[x](<javascript:alert(1)>)",
    "[x](java&#x0A;script:alert(1))",
    "[x](&#106;avascript:alert(1))",
    "[x](&#1;javascript:alert(1))",
    "[x](vbscript:msgbox(1))",
    "[x](data:text/html;base64,PHNjcmlwdD4=)",
    "[x](file:///etc/passwd)",
    "[x](//x.example/share)",
    "[x](\\\\\\\\x.example\\\\share)",
    "<javascript:alert(1)>",
    "<data:text/html,x>",
    "[x][r]\n\n[r]: javascript:alert(1)",
    "[r]\n\n[r]: <data:text/html,x> 'title'",
    "[**b** `c`](javascript:alert(1) \"title\")",
    "![x](http://x.example/pixel.png)",
    "![x](//x.example/pixel.png)",
    "![x](data:image/svg+xml,<svg/onload=alert(1)>)",
    "![x](javascript:alert(1))",
    "![x][p]\n\n[p]: http://x.example/pixel.png",
    "[![x](http://x.example/p.png)](javascript:alert(1))",
    "![a\" onerror=\"alert(1)](x.svg\" onerror=\"alert(1))",
    "| a |\n|:--|\n| <img src=x onerror=alert(1)> |",
    "> <script>alert(1)</script>",
    "- <iframe srcdoc=\"<script>alert(1)</script>\">",
    "$\\text{<script>alert(1)</script>}$",
    "$\\text{</mtext></math><img src=x onerror=alert(1)>}$",
    "$<img src=x onerror=alert(1)>$",
    "$\\href{javascript:alert(1)}{x}$",
    "`<script>alert(1)</script>`",
    "<<b>script>alert(1)<</b>/script>",
    "<<<b>b>script>alert(1)<<<b>b>/script>",
    "<scr<!-- -->ipt>alert(1)</scr<!-- -->ipt>",
    "<div><scr<b>ipt>alert(1)</scr</b>ipt></div>",
    "<div>\n<scr<p>ipt src=x>\n</div>",
    "<im<b>g src=x onerror=alert(1)></b>",
    "<p><<p>img src=x onerror=alert(1)></p>",
    "<div><div><div><img src=x onerror=alert(1)></div></div></div>",
    "<div\nonclick=alert(1)>x</div>",
    "<div\n\n<img src=x onerror=alert(1)>",
    "<script>\nalert(1)",
    "<img src=x onerror=alert(1)\n\n>",
    "<img src='x>\n<script>alert(1)</script>",
    "<!-- <script>alert(1)</script>",
    "<!--> <script>alert(1)</script> -->",
    "<div><![CDATA[\n\n<script>alert(1)</script>\n\n]]></div>",
    "<div><?xml <script>alert(1)</script> ?></div>",
    "<!DOCTYPE x <script>alert(1)</script>>",
    "<p>[x]: javascript:alert(1)\n\n[x]</p>",
    "<p>[x](java<b>script:alert(1))</p>",
    "<p>![x](http://x.example/p.png)</p>",
    "<template><img src=x onerror=alert(1)></template>",
    "<textarea></textarea><script>alert(1)</script></textarea>",
    "<svg><style><img src=x onerror=alert(1)></style></svg>",
    "&lt;script>alert(1)&lt;/script>",
    "\u{fffe}<script>alert(1)</script>",
    "<\u{fffe}script>alert(1)</script>",
];

/// What makes an element act or fetch something; empty for what may stand.
fn acts(element: ElementRef) -> Vec<String> {
    const NEVER: [&str; 14] = [
        "script", "iframe", "object", "embed", "link", "base", "form", "input", "img", "video", "audio",
        "source", "frame", "applet",
    ];
    let value = element.value();
    let mut found = Vec::new();
    if NEVER.contains(&value.name()) {
        found.push(format!("<{}>", value.name()));
    }
    for (name, text) in value.attrs() {
        let inside = text.starts_with('#');
        let address = matches!(
            name,
            "href" | "src" | "xlink:href" | "action" | "data" | "srcdoc" | "poster" | "background"
        );
        if name.starts_with("on") || address && !inside || name == "style" && text.contains("url(") {
            found.push(format!("{name}={text:?}"));
        }
    }
    if value.name() == "style" {
        // The font of formulas stands in the page.
        let text = element.text().collect::<String>().replace("url(data:font/woff2;base64,", "");
        found.extend(["url(", "@import"].iter().filter(|w| text.contains(*w)).map(|w| (*w).to_owned()));
    }
    found
}

fn all_acts(page: &str) -> Vec<String> {
    let parsed = Html::parse_document(page);
    parsed.root_element().descendent_elements().flat_map(acts).collect()
}

#[test]
fn nothing_active_leaves_a_statement() {
    let words = Words::english();
    let templates = Templates::english();
    let head = Head { title: "<script>x</script>".to_owned(), student: "s".to_owned(), ..Head::default() };
    for text in ACTIVE {
        let raw = format!("# Problem\n\nBefore.\n\n{text}\n\nAfter the text.\n");
        let document = Document::new(raw.clone(), Vec::new());
        // HTML, also where somebody writes a document without the filter.
        for document in [&document, &Document { markdown: raw.clone(), pictures: Vec::new() }] {
            let body = Converter::new(&words).body(document, &document.screens(), PlaceInPage::default());
            let page = html::page(&templates, &words, "sheet", &head, &body, None).unwrap();
            let found: Vec<String> = all_acts(&String::from_utf8(page).unwrap());
            let is_filtered = document.markdown != raw;
            assert!(
                found.is_empty() || !is_filtered && found.iter().all(|f| f.starts_with("href=")),
                "{text}: {found:?}"
            );
        }
        // Markdown: what a viewer would make of it, all of its HTML let through.
        let plain = document.plain();
        let mut page = String::new();
        let seen = pulldown_cmark::Parser::new_ext(&plain, html::MARKDOWN);
        let seen = seen.map(|e| match e {
            // Formulas are a matter of the viewer; as text here.
            pulldown_cmark::Event::InlineMath(t) | pulldown_cmark::Event::DisplayMath(t) => {
                pulldown_cmark::Event::Text(t)
            }
            e => e,
        });
        pulldown_cmark::html::push_html(&mut page, seen);
        assert_eq!(all_acts(&without_tools(&page)), Vec::<String>::new(), "{text}: {plain}");
        assert_eq!(dropped(&plain), Vec::<Dropped>::new(), "{text}: {plain}");
        assert!(plain.starts_with("# Problem\n\nBefore."), "{text}: {plain}");
        // Typst has no HTML, and links only to the web.
        if let Ok(source) = typst::source(&[(&Head::default(), &document)], &words) {
            for (i, _) in source.match_indices("#link(\"") {
                assert!(source[i + 7..].starts_with("http"), "{text}: {source}");
            }
        }
    }
    // Honest ones stay.
    for text in [
        "[web](https://a.example/b?c=d#e) and [mail](mailto:a@b.example), <https://a.example>, <a@b.example>",
        "[below](#hints), [beside](../hints.html)",
        "$a < b$ and 3 < 4, `<script>`",
        "![a wheel](problem-1.svg)",
        "- x <!-- answer -->\n- y<br>z",
    ] {
        assert_eq!(Document::new(text.to_owned(), Vec::new()).markdown, text);
        assert_eq!(dropped(text), Vec::new());
    }
    let kept = |text: &str| Document::new(text.to_owned(), Vec::new()).markdown;
    assert_eq!(kept("a [**b** c](javascript:x) d ![alt *e*](http://x/y) f"), "a **b** c d alt *e* f");
    assert_eq!(kept("a <b>c</b> d"), "a c d");
}

/// Tags go and words stay, in blocks and in lines, and the words are Markdown like any other. Earlier tests looked only at what must
/// not reach students, never at what must: a statement in HTML lost all of its data.
#[test]
fn words_and_data_between_tags_stay() {
    let kept = |text: &str| Document::new(text.to_owned(), Vec::new()).markdown.trim().to_owned();
    for (text, expected) in [
        ("<p>A disc of mass $m = 4$ and radius <b>$R$</b>.</p>", "A disc of mass $m = 4$ and radius $R$."),
        ("<div>\nA disc of $m$.\n\nIt rolls.\n</div>", "A disc of $m$.\n\nIt rolls.\n"),
        ("<div>\nA disc.\nIt rolls.", "A disc.\nIt rolls."),
        ("Before <span class=x>a *b* c</span> after", "Before a *b* c after"),
        ("<td>1</td><td>2</td>", "1 2"),
        ("10<sup>3</sup> and v<sub>0</sub>", "10^3 and v\\_0"),
        ("<p>10<sup>3</sup></p>", "10^3"),
        ("<div>\n    <p>Set in, $m$.</p>\n</div>", "Set in, $m$."),
        ("<p>if $a<b$ then $c>d$</p>", "if $a<b$ then $c>d$"),
        ("a <script>no()</script> b<style>\nx{}\n</style> c", "a  b c"),
        ("<script>\nno()\n\nno()\n</script>\nA disc.", "A disc."),
        ("<!-- secret\n\nkey --> A disc.", "A disc."),
        ("<!-- answer --> A disc.", "A disc."),
        ("<div\n\nA disc.", "&lt;div\n\nA disc."),
        ("<br>\nA disc.", "A disc."),
        ("> <p>A disc.</p>", "> A disc."),
        ("<script>\nA disc.", "A disc."),
        ("<table><tr><th>m</th><td>2 kg</td></tr></table>", "m 2 kg"),
    ] {
        assert_eq!(kept(text), expected.trim(), "{text}");
    }
    // Many of them take no time to speak of.
    let begin = Instant::now();
    for many in ["<script>", "<!--", "<div>\n", "<p a='", "<b>", "<![CDATA[", "<div\n\n", "<<b>"] {
        let many = format!("A\n\n{}", many.repeat(20_000));
        assert!(kept(&many).starts_with('A'));
    }
    assert!(begin.elapsed() < Duration::from_secs(60), "{:?}", begin.elapsed());
    // The sheets of a whole statement in HTML.
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    let text = bank("", "the speed", "A block")
        .replace("The mass is", "<p>The mass is")
        .replace("{{ g }}.", "{{ g }}.</p>");
    assert!(text.contains("<p>The mass is {{ m }}"), "{text}");
    fs::write(path("b.yaml"), text).unwrap();
    fs::write(path("r.csv"), "student,name\ns1,A\n").unwrap();
    let (file, roster, set) = (path("b.yaml"), path("r.csv"), path("set"));
    let (exit, _, err) = program::generate(&file, &roster, &set, &["--format", "html,md,tex"]).parts();
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(
        err.contains("note: problems.slide: `<p>` is dropped: the tags are dropped, the words stay"),
        "{err}"
    );
    for sheet in files(Path::new(&set)).into_iter().filter(|f| f.file_stem().is_some_and(|s| s == "sheet")) {
        if sheet.extension().is_some_and(|e| e != "json") {
            let sheet = fs::read_to_string(&sheet).unwrap();
            assert!(
                sheet.contains("The mass is")
                    && sheet.contains("9.81")
                    && !sheet.contains("<p>The mass is <p>"),
                "{sheet}"
            );
        }
    }
}

/// LaTeX that would read, write or never end: no formula and no text of it is carried out.
#[test]
fn nothing_in_a_statement_is_carried_out_by_latex() {
    const ACTIVE: [&str; 24] = [
        r"\input{/etc/passwd}",
        r"\include{x}",
        r"\write18{rm -rf x}",
        r"\immediate\write18{ls}",
        r"\openout\x=x",
        r"\openin5=/etc/passwd",
        r"\read5 to\x",
        r"\special{x}",
        r"\directlua{os.execute('x')}",
        r"\catcode`\@=0",
        r"\csname input\endcsname{x}",
        r"\def\x{\x}\x",
        r"\let\x=\input \x{y}",
        r"\newcommand{\x}{\input{y}}\x",
        r"\loop\iftrue\repeat",
        r"\includegraphics{/etc/x}",
        r"\href{javascript:x}{y}",
        r"\url{x}",
        r"\end{document}",
        r"\begin{filecontents}x\end{filecontents}",
        r"^^5cinput{x}",
        r"\text{\input{/etc/passwd}}",
        r"\textrm{a $\write18{x}$ b}",
        r"\colorbox{red}{\input{x}}",
    ];
    const WORDS: [&str; 23] = [
        "input",
        "include",
        "write",
        "immediate",
        "openout",
        "openin",
        "read",
        "special",
        "directlua",
        "catcode",
        "csname",
        "def",
        "let",
        "newcommand",
        "loop",
        "includegraphics",
        "href",
        "url",
        "iftrue",
        "repeat",
        "endcsname",
        "x",
        "document",
    ];
    for active in ACTIVE {
        for text in [
            active.to_owned(),
            format!("${active}$"),
            format!("$${active}$$"),
            format!("**{active}** `{active}`"),
            format!("# {active}"),
            format!("| {active} |\n|:--|\n| ${active}$ |"),
            format!("![{active}](x.svg) [{active}](https://{active})"),
            format!("```{active}\n{active}\n```"),
        ] {
            let document = Document::new(format!("A\n\n{text}\n\nB\n"), Vec::new());
            let latex = tex::body(&document);
            assert!(!latex.contains("^^") && !latex.contains("filecontents}\\"), "{text}: {latex}");
            for (i, _) in latex.match_indices('\\') {
                // `\\` ends a line.
                if latex[..i].ends_with('\\') {
                    continue;
                }
                let word: String = latex[i + 1..].chars().take_while(char::is_ascii_alphabetic).collect();
                assert!(!WORDS.contains(&word.as_str()), "{text}: \\{word} in {latex}");
            }
            if let Ok(source) = typst::source(&[(&Head::default(), &document)], &Words::english()) {
                for call in ["#read(", "#include", "#import \"@", "#eval(", "#plugin("] {
                    assert!(!source.contains(call), "{text}: {source}");
                }
            }
        }
        // `generate` refuses it, `lint` names it.
        let faults = formula::faulty_formulas(&format!("${active}$"));
        assert_eq!(faults.len(), 1, "{active}: {faults:?}");
    }
}

/// From the bank to the files: the students' files hold nothing active, and `lint` says what is dropped.
#[test]
fn lint_tells_what_students_will_not_see() {
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    let text = "A <b onclick=alert(1)>bold</b> word, a [link](javascript:alert(1)), and\n\
                ![seen](http://x.example/p.png) from afar; [more](https://a.example).\n\n<script>alert(1)</script>\n\nEnd.";
    fs::write(path("b.yaml"), bank(text, "the <i>speed</i>", "'A <u>block</u>'")).unwrap();
    fs::write(path("r.csv"), "student,name\ns1,A\n").unwrap();
    let (exit, out, err) = run(&["lint", &path("b.yaml"), "--seeds", "20"]);
    assert_eq!((exit, err.as_str()), (Exit::Fine, ""));
    for note in [
        "note: `<b onclick=alert(1)>` is dropped",
        "note: `<script>alert(1)</script>` is dropped",
        "note: the link to `javascript:alert(1)` is dropped",
        "note: the picture `http://x.example/p.png` is dropped",
        "note: `<i>` is dropped",
        "note: `<u>` is dropped",
    ] {
        assert!(out.contains(note), "{note}: {out}");
    }
    assert!(!out.contains("a.example"), "{out}");
    let (roster, set) = (path("r.csv"), path("set"));
    let file = path("b.yaml");
    let (exit, _, err) = program::generate(&file, &roster, &set, &["--format", "html,md,tex"]).parts();
    // The same is noted before sheets go out.
    assert_eq!(exit, Exit::Fine, "{err}");
    assert!(err.contains("note: problems.slide: `<u>` is dropped"), "{err}");
    assert!(err.lines().all(|l| l.starts_with("note: ") && l.contains(" is dropped: ")), "{err}");
    let mut seen = 0;
    for file in files(Path::new(&set)) {
        let ending = file.extension().unwrap_or_default().to_string_lossy().into_owned();
        if matches!(ending.as_str(), "html" | "md" | "tex") {
            let text = without_tools(&fs::read_to_string(&file).unwrap());
            for word in ["<script", "javascript:", "x.example", "onclick", "<b>", "<u>", "<i>"] {
                // In LaTeX a tag is a text like any other.
                let is_text = word.len() == 3 && ending == "tex";
                assert!(is_text || !text.contains(word), "{}: {word}", file.display());
            }
            seen += 1;
        }
    }
    assert!(seen >= 5, "{seen} files");
    let sheet = fs::read_to_string(Path::new(&set).join("students/s1/sheet.md")).unwrap();
    assert!(
        sheet.contains("A bold word, a link, and\nseen from afar; [more](https://a.example)."),
        "{sheet}"
    );
}

/// A page without the tools by which a sheet checks itself: its boxes, and what stands behind the document. Only the script of the
/// program is among them, and what others wrote stands in its data, where nothing acts.
fn without_tools(page: &str) -> String {
    let Some((body, rest)) = page.split_once("<noscript>") else { return page.to_owned() };
    let (tools, end) = rest.split_once("</main>").unwrap();
    let scripts: Vec<&str> = tools.matches("<script").collect();
    assert_eq!(scripts.len(), 3, "data, program and script");
    assert!(!end.contains("<script"), "{end}");
    let mut out = String::new();
    for piece in body.split("<input name=\"") {
        let piece = if out.is_empty() { piece } else { piece.split_once('>').unwrap().1 };
        out.push_str(piece);
    }
    out + end
}

/// Names of all kinds that mean harm, on every page that shows them.
#[test]
fn hostile_names_act_on_no_page() {
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    let evil = "<script>alert(1)</script><img src=x onerror=alert(2)>[x](javascript:alert(3))![y](http://x.example/y.png)";
    let bank = bank("", &format!("the speed {evil}"), &format!("'A {evil}'"))
        .replace("name: mass,", &format!("name: 'mass {evil}', tex: 'm<b onclick=alert(4)>',"))
        .replace(
            "    questions:",
            "    cases:\n      'one <script>alert(5)</script>': {share: 1}\n      'two \" onload=alert(6) x=\"': {share: 1}\n    questions:",
        );
    fs::write(path("b.yaml"), bank).unwrap();
    fs::write(path("r.csv"), "student,name\ns1,<script>alert(7)</script>\n\"<b onclick=alert(8)>\",B\n")
        .unwrap();
    let fine = |args: &[&str]| {
        let (exit, out, err) = run(args);
        let told = err.lines().all(|l| l.starts_with("note: ") && l.contains(" is dropped: "));
        assert!(exit == Exit::Fine && told, "{args:?}: {out}{err}");
    };
    let (file, roster, set, grades) = (path("b.yaml"), path("r.csv"), path("set"), path("grades"));
    fine(&["gallery", &file, "--variants", "4", "--seeds", "20", "--out", &path("gallery.html")]);
    fine(&["generate", &file, "--roster", &roster, "--seed", "1", "--out", &set]);
    fine(&["solutions", &set, "--out", &path("solutions")]);
    let answers =
        "student,problem,part,answer\ns1,1,v,<script>alert(9)</script>\n\"<b onclick=alert(8)>\",1,v,1 m/s\n";
    fs::write(path("a.csv"), answers).unwrap();
    fine(&["grade", &set, &path("a.csv"), "--out", &grades]);
    let mut pages = 0;
    for file in files(room.path()).into_iter().filter(|f| f.extension().is_some_and(|e| e == "html")) {
        let page = fs::read_to_string(&file).unwrap();
        let mut acts = all_acts(&without_tools(&page));
        if file.ends_with("index.html") {
            acts.retain(|act| !leads_beside(&file, act));
        }
        assert_eq!(acts, Vec::<String>::new(), "{}", file.display());
        pages += 1;
    }
    assert!(pages >= 10, "{pages} pages");
}

/// Is it a link of an index to what lies beside it, a file that is there? Its name is written with escapes (`%20`).
fn leads_beside(index: &Path, act: &str) -> bool {
    let Some(link) = act.strip_prefix("href=\"").and_then(|a| a.strip_suffix('"')) else { return false };
    let mut pieces = link.split('%');
    let mut name = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let Some(code) = piece.get(..2).and_then(|c| u8::from_str_radix(c, 16).ok()) else { return false };
        name.push(char::from(code));
        name.push_str(&piece[2..]);
    }
    index.with_file_name(name).is_file()
}

fn files(folder: &Path) -> Vec<std::path::PathBuf> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { all.extend(files(&path)) } else { all.push(path) }
    }
    all
}

/// Every kind of page that the program writes has a policy before anything else, and asks nothing of anybody.
#[test]
fn every_page_is_closed_to_the_outside() {
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    let fine = |args: &[&str]| {
        let (exit, out, err) = run(args);
        assert_eq!((exit, err.as_str()), (Exit::Fine, ""), "{args:?}: {out}");
    };
    let demo = path("demo");
    fine(&["demo", &demo]);
    let set = Path::new(&demo).join("set").display().to_string();
    fine(&["solutions", &set, "--out", &path("solutions")]);
    fine(&[
        "gallery",
        "hoists-and-pulleys",
        "--variants",
        "2",
        "--seeds",
        "20",
        "--out",
        &path("gallery.html"),
    ]);
    fine(&[
        "accuracy",
        "wheels-on-inclines",
        "spring-released",
        "--seed",
        "5",
        "--no-time",
        "--out",
        &path("a.html"),
    ]);
    fine(&["help", "--html", &path("manual.html")]);
    // Somebody's own template is closed, too.
    fs::create_dir(path("mine")).unwrap();
    fs::write(path("mine/sheet.html"), "<!DOCTYPE html>\n<HTML><HEAD lang=\"en\"><title>{{ title }}</title></HEAD><body>{{ body }}</body></HTML>")
        .unwrap();
    fs::write(path("r.csv"), "student,name\ns1,A\n").unwrap();
    let (mine, roster, own) = (path("mine"), path("r.csv"), path("own"));
    fine(&[
        "generate",
        "slip-and-roll",
        "--roster",
        &roster,
        "--seed",
        "1",
        "--templates",
        &mine,
        "--out",
        &own,
    ]);
    let mut kinds = std::collections::BTreeSet::new();
    for file in files(room.path()) {
        if file.extension().is_none_or(|e| e != "html") || file.starts_with(&mine) {
            continue;
        }
        let page = fs::read_to_string(&file).unwrap();
        let parsed = Html::parse_document(&page);
        let head = scraper::Selector::parse("head > *").unwrap();
        let first = parsed.select(&head).next().unwrap().value();
        assert_eq!(first.attr("http-equiv"), Some("Content-Security-Policy"), "{}", file.display());
        let policy = first.attr("content").unwrap();
        let mut allowed: Vec<&str> = policy.split(';').map(str::trim).collect();
        // A sheet that checks itself runs its own script, known by its hash, and the program; nothing else runs anywhere.
        let runs =
            |part: &str| part.starts_with("script-src 'sha256-") && part.ends_with("=' 'wasm-unsafe-eval'");
        assert_eq!(
            allowed.iter().any(|part| runs(part)),
            page.contains("id=\"program\""),
            "{}",
            file.display()
        );
        allowed.retain(|part| !runs(part));
        for part in [
            "default-src 'none'",
            "style-src 'unsafe-inline'",
            "font-src data:",
            "img-src data:",
            "base-uri 'none'",
            "form-action 'none'",
        ] {
            assert!(allowed.contains(&part), "{part}: {policy}");
        }
        assert_eq!(allowed.len(), 6, "{policy}");
        let mut acts = all_acts(&without_tools(&page));
        if file.ends_with("index.html") {
            let before = acts.len();
            acts.retain(|act| !leads_beside(&file, act));
            assert!(before > acts.len() + 6, "{before} links, {acts:?}");
        }
        if file.ends_with("manual.html") {
            // Its pictures stand in it, and a link to elsewhere is followed only by who clicks it.
            let within = ["<img>", "src=\"data:image/svg+xml", "href=\"https://"];
            acts.retain(|act| !within.iter().any(|w| act.starts_with(w)));
        }
        assert_eq!(acts, Vec::<String>::new(), "{}", file.display());
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let parent = file.parent().unwrap().file_name().unwrap().to_string_lossy().into_owned();
        kinds.insert(if parent == "feedback" { parent } else { name });
    }
    for kind in [
        "sheet.html",
        "solution.html",
        "booklet.html",
        "key-table.html",
        "report.html",
        "feedback",
        "gallery.html",
        "index.html",
        "manual.html",
        "a.html",
    ] {
        assert!(kinds.contains(kind), "{kind} in {kinds:?}");
    }
}

/// The policy stands where a browser heeds it, wherever the word `head` stands in somebody's own template. The earlier test gave one
/// template of its own, whose first `<head` was the head.
#[test]
fn the_policy_is_in_the_real_head() {
    for page in [
        "<!DOCTYPE html><!-- <head> --><html><head><title>x</title></head><body>y</body></html>",
        "<!-- <head> --><!DOCTYPE html><html><head><script>x</script></head></html>",
        "<!DOCTYPE html>\n<html lang=en>\n<!-- a\n<HEAD >\n--> <!--> <!---> <!-- b --!>\n<HEAD data-x='a>b'>\n<script>x</script></HEAD></html>",
        "<!DOCTYPE html><title>The <head> of it</title><script>x</script>",
        "<!DOCTYPE html><html><header>a</header><script>x</script></html>",
        "<script>'<head>'</script><p>no head</p>",
        "<p title='<head>'>x</p>",
        "<html><body><!-- <head> -->x</body></html>",
        "<!-- <html><head>",
        "x",
        "",
    ] {
        let long = format!("<!--{}-->", "x".repeat(5000));
        for page in [page.to_owned(), format!("{long}{page}"), format!("\n {page}")] {
            let own = [("mine.html".to_owned(), "mine.html".to_owned(), page.clone())];
            let templates = Templates::new("en", &own).map_err(|f| f[0].to_string()).unwrap();
            let mut out = Vec::new();
            templates.render("mine.html", &View::new(), &mut out).unwrap();
            let out = String::from_utf8(out).unwrap();
            let parsed = Html::parse_document(&out);
            let head = scraper::Selector::parse("head > *").unwrap();
            let first = parsed.select(&head).next().map(|e| e.value().attr("http-equiv"));
            assert_eq!(first, Some(Some("Content-Security-Policy")), "{page}: {out}");
        }
    }
}
