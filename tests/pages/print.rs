//! What goes to print, as text: formulas in Typst's way and in words, Markdown in Typst's way, foreign text. No program is
//! needed; `pdf.rs` beside this file compiles what comes out here.
use crate::support;
use slipstick::picture::Picture;
use slipstick::problem::maker::Maker;
use slipstick::sheet::document::{Document, Head};
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::sheet::typst::{TypstFormula, formula, source};
use slipstick::solution;
use slipstick::words::Words;

fn translated(tex: &str) -> TypstFormula {
    formula(tex, true, &Words::english()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn typst(markdown: &str) -> Result<String, String> {
    let document = Document { markdown: markdown.to_owned(), pictures: Vec::new() };
    let text = source(&[(&Head::default(), &document)], &Words::english()).map_err(|f| f.message)?;
    let body = text.split(")[\n").last().and_then(|b| b.strip_suffix("\n\n];\n"));
    Ok(body.unwrap_or(&text).to_owned())
}

#[test]
fn formulas_in_typst_and_in_words() {
    for (tex, typst, alt) in [
        (r"m = 40\ \mathrm{kg}", "m =\"40\"#h(0.25em)\"kg\"", "m = 40 kg"),
        (
            r"0{,}25\ \mathrm{m}/\mathrm{s}^{2}",
            "\"0,25\"#h(0.25em)\"m\"class(\"normal\", \\/) attach(\"s\", tr: \"2\")",
            "0,25 m/s^2",
        ),
        (r"\theta = 30^\circ", "θ = attach(\"30\", tr: ∘)", "θ = 30°"),
        (r"\mu_s", "attach(μ, br: s)", "μ_s"),
        (r"x_{1{,}2}^2", "attach(x, br: \"1,2\", tr: \"2\")", "x_1,2^2"),
        (r"\frac{1}{2} m v^2", "frac(\"1\", \"2\") m attach(v, tr: \"2\")", "1/2 mv^2"),
        (r"\sqrt{2 g h}", "sqrt(\"2\"g h)", "square root of (2gh)"),
        (r"\sqrt[3]{x}", "root(\"3\", x)", "root of order 3 of (x)"),
        (r"\dot{x} + \ddot\theta", "dot(x) + dot.double(θ)", "x dot + θ double dot"),
        (r"\vec v", "arrow(v)", "vector v"),
        (r"m g \sin\theta", "m g op(\"sin\") θ", "mg sin θ"),
        (r"\left(a + b\right)", "lr(\\( a + b \\))", "(a + b)"),
        (
            r"\lvert F \rvert \le \mu_s N",
            "class(\"opening\", \\|) F class(\"closing\", \\|) ≤ attach(μ, br: s) N",
            "|F| ≤ μ_s N",
        ),
        (r"\int_0^d F\,\mathrm{d}x", "attach(∫, br: \"0\", tr: d) F #h(0.1667em)\"d\"x", "∫_0^d F dx"),
        (r"\sum_i M_i", "attach(limits(∑), b: i) attach(M, br: i)", "∑_i M_i"),
        (r"\begin{aligned} a &= b \\ c &= d \end{aligned}", "a & = b \\\nc & = d", "a = b; c = d"),
        (
            r"\begin{cases} 1 & x > 0 \\ 0 & \text{else} \end{cases}",
            "cases(\"1\" & x >\"0\", \"0\" & \"else\")",
            "{ 1 x > 0; 0 else }",
        ),
        (
            r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}",
            "lr(\\( mat(delim: #none, align: #center, a, b; c, d) \\))",
            "((a b; c d))",
        ),
        (r"f(x, y)", "f class(\"opening\", \\() x \\, y class(\"closing\", \\))", "f(x, y)"),
        (r"\Delta E \approx 3 \pm 1 \Rightarrow x", "upright(Δ) E ≈\"3\"±\"1\"⇒ x", "ΔE ≈ 3 ± 1 ⇒ x"),
        (r"x'", "x attach(\"\", tr: ′)", "x′"),
    ] {
        let found = translated(tex);
        assert_eq!(found.typst, typst, "{tex}");
        assert_eq!(found.alt, alt, "{tex}");
    }
}

#[test]
fn what_has_no_translation_is_a_finding() {
    for (markdown, word) in [
        (r"$\unknown x$", "formula"),
        (r"$\color{red} x$", "colours"),
        (r"$\begin{array}{c|c} a & b \end{array}$", "lines"),
        (r"$\frac{1}$", "formula"),
        (r"$x^$", "formula"),
        ("<table><tr></table>", "HTML"),
        ("![a wheel](wheel.svg)", "no picture wheel.svg"),
    ] {
        let fault = typst(markdown).expect_err(markdown);
        assert!(fault.contains(word), "{markdown}: {fault}");
    }
}

#[test]
fn markup_of_others_stays_text() {
    let nasty = "Zoë #1 *M* _u_ $x$ <lab> @a `c` \\ [b] ~ 1. - + = / // \"q\" 'r' #panic() {x} https://a.b";
    let mut escaped = String::new();
    for c in nasty.chars() {
        if c.is_ascii_punctuation() {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    let body = typst(&escaped).expect("plain text");
    let mut plain = String::new();
    let mut letters = body.chars();
    while let Some(c) = letters.next() {
        match c {
            '\\' => plain.extend(letters.next()),
            '#' | '*' | '_' | '$' | '<' | '@' | '`' | '[' | '~' | '=' | '/' | '\'' | '"' => {
                panic!("{c} is markup in {body}")
            }
            c => plain.push(c),
        }
    }
    assert_eq!(plain.trim(), nasty);
    // In a head it is a text in quotes.
    let head = Head { name: nasty.to_owned(), ..Head::default() };
    let text = source(&[(&head, &Document::default())], &Words::english()).expect("a page");
    let quoted = format!("name: \"{}\"", nasty.replace('\\', "\\\\").replace('"', "\\\""));
    assert!(text.contains(&quoted), "{text}");
}

#[test]
fn markdown_in_typst() {
    for (markdown, typst_text) in [
        ("# A & B", "#heading(level: 1)[A & B];"),
        ("**a** *b* `c_d`", "#strong[a]; #emph[b]; #raw(\"c_d\");"),
        ("3. x\n4. y", "#enum(start: 3, [x],\n[y],\n);"),
        ("- x <!-- answer -->", "#list([#question(labels)[x ];],\n);"),
        ("x\n\n<!-- answer -->\n\ny", "x\n\n#answer(labels);\ny"),
        (
            "| a | b |\n|:--|--:|\n| $1$ | 2 |",
            "#table(columns: 2, align: (left, right,), table.header([a], [b], ),\n[#box(math.equation(alt: \"1\", block: false, $\"1\"$));], [2], \n);",
        ),
        ("```\na \"b\"\n\\c\n```", "#raw(block: true, \"a \\\"b\\\"\\n\\\\c\\n\");"),
        ("---", "#rule();"),
        ("a  \nb", "a#linebreak();b"),
        ("[a](https://b.c/d)", "#link(\"https://b.c/d\")[a];"),
        ("$$x$$", "#math.equation(alt: \"x\", block: true, $ x $);"),
    ] {
        assert_eq!(typst(markdown).expect(markdown), typst_text, "{markdown}");
    }
}

#[test]
fn a_picture_brings_its_words() {
    let picture = Picture {
        width: 200.0,
        height: 100.0,
        title: "t".to_owned(),
        desc: "A \"wheel\".".to_owned(),
        elements: Vec::new(),
        labels: Vec::new(),
    };
    let document =
        Document { markdown: "![other](w.svg)\n".to_owned(), pictures: vec![("w".to_owned(), picture)] };
    let text = source(&[(&Head::default(), &document)], &Words::english()).expect("a page");
    assert!(text.contains("width: 150pt, alt: \"A \\\"wheel\\\".\""), "{text}");
}

/// Sheets and solutions of every family in every language.
#[test]
fn every_formula_of_every_family_is_translated() {
    for language in Words::languages() {
        let words = Words::of(language).expect("a language");
        for bank in support::banks_in(language) {
            let templates = support::templates(language, &bank);
            for (index, problem) in bank.problems.iter().enumerate() {
                let maker = Maker::new(problem, 5, "print");
                let sheets = Sheets::new(&templates, &words, &bank, "print", &[index]).expect("templates");
                let mut room = SheetScratch::default();
                let mut formulas = 0;
                for student in 0..30 {
                    let variant = maker.variant(&student.to_string()).expect("satisfiable");
                    let (head, document) = sheets
                        .document("s", "Name", std::slice::from_ref(&variant), &mut room)
                        .expect("a sheet");
                    let text = source(&[(&head, &document)], &words);
                    let text = text.unwrap_or_else(|f| panic!("{language} {} {student}: {f}", problem.id));
                    formulas += text.matches("math.equation(alt:").count();
                    if student < 4 {
                        let solution = solution::document(problem, &variant, 1, &words, &templates);
                        let solution = solution.unwrap_or_else(|f| panic!("{}: {f}", problem.id));
                        let text = source(&[(&head, &solution)], &words);
                        text.unwrap_or_else(|f| panic!("{language} {} {student}: {f}", problem.id));
                    }
                }
                assert!(formulas > 30, "{}: {formulas} formulas", problem.id);
            }
        }
    }
}
