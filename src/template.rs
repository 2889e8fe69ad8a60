//! Name and view to text, in one language; keeper of the Tera crate.
//!
//! Views hold finished strings: numbers, units and formulas are text already and marked as such, names of people are
//! not and are escaped for the format. A variable that does not exist is an error with its place, never an empty text.
//! Templates that the program did not bring along are metered (`template::metered`).
mod metered;

use crate::finding::{Finding, Findings};
use crate::template::metered::Metered;
use std::collections::BTreeMap;
use std::io;
use tera::{Context, ErrorKind, Tera};

pub use tera::{Map, Value};

/// Names of templates below a folder, with their texts.
macro_rules! built_in {
    ($folder:literal: $($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../templates/", $folder, $name)))),*]
    };
}

/// Templates below a folder that hold words, of which each language has its own.
macro_rules! in_words {
    ($folder:literal) => {
        built_in!($folder:
            "sheet.md",
            "questions.md",
            "feedback.md",
            "key-table.md",
            "statement/compound-pendulum.md",
            "statement/falling-rod.md",
            "statement/kinetic-energy.md",
            "statement/lifted-rod.md",
            "statement/pulled-rolling.md",
            "statement/pulled-slipping.md",
            "statement/rod-and-spring.md",
            "statement/spring-released.md",
            "statement/thrown-ball.md",
            "statement/wheel-set-down.md",
        )
    };
}

/// The templates that the program brings along: name, text. First those with words, by language.
const WORDED: &[(&str, &[(&str, &str)])] = &[("en", in_words!("")), ("de", in_words!("de/"))];

/// Those that are looks, not words, and the same in all languages.
const LOOKS: &[(&str, &str)] = built_in!("":
    "solution/default.md",
    "style.html",
    "math-font.html",
    "sheet.html",
    "page.html",
    "booklet.html",
    "style.tex",
    "sheet.tex",
    "booklet.tex",
    "accuracy.html",
    "gallery.html",
    "manual.html",
    "index.html",
    "report.html",
    "report-table.html",
);

/// The built-in templates of a language, or else the English ones: name, text.
pub fn built_in(language: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let (_, own) = WORDED.iter().find(|(code, _)| *code == language).unwrap_or(&WORDED[0]);
    own.iter().chain(LOOKS).copied()
}

/// How text that somebody else wrote is escaped in templates whose name ends so.
type Escape = fn(&str, &mut dyn io::Write) -> io::Result<()>;
const ENGINES: [(&str, Escape); 3] = [(".md", escape_markdown), (".html", escape_html), (".tex", escape_tex)];

/// Is this the name of a template?
pub fn is_template(name: &str) -> bool {
    ENGINES.iter().any(|(end, _)| name.ends_with(end))
}

/// All templates of one language, compiled: one engine for each format, built once and shared by all threads.
pub struct Templates {
    engines: Vec<(&'static str, Tera)>,
    /// Where the templates given by the user came from: name to path.
    files: BTreeMap<String, String>,
    /// Templates that stand inside another file: name to its path, line and column there.
    within: BTreeMap<String, TemplatePlace>,
    /// Templates with a meter, by name.
    metered: BTreeMap<String, Metered>,
}

/// Where a text stands: file, line and column counted from 1.
pub type TemplatePlace = (String, usize, usize);

/// What a template sees. Values put in as finished text are not escaped again.
#[derive(Clone, Default)]
pub struct View {
    context: Context,
    /// About how long all of it is.
    size: usize,
    /// What a page may do besides, as directives of its policy.
    runs: String,
}

impl View {
    /// An empty view.
    pub fn new() -> Self {
        Self::default()
    }
    /// Puts in a finished text.
    pub fn text(&mut self, name: impl Into<String>, text: &str) {
        self.value(name, Value::safe_string(text));
    }
    /// Puts in a text that somebody else wrote, to be escaped.
    pub fn foreign(&mut self, name: impl Into<String>, text: &str) {
        self.value(name, Value::normal_string(text));
    }
    /// Puts in a list or map that was made before.
    pub fn value(&mut self, name: impl Into<String>, value: Value) {
        let name = name.into();
        let was = self.context.get(&name).map_or(0, |was| metered::size(was, usize::MAX));
        self.size = self.size.saturating_sub(was).saturating_add(metered::size(&value, usize::MAX));
        self.context.insert_value(name, value);
    }
    /// Puts in the fields of a struct, each under its name; the texts in them are escaped.
    pub fn fields(&mut self, data: &impl serde::Serialize) {
        let data = Value::from_serializable(data);
        for (name, value) in data.as_map().into_iter().flatten() {
            self.value(name.as_str().unwrap_or_default(), value.clone());
        }
    }
    /// Lets a page run and fetch what these directives of its policy say, each with a semicolon and a blank behind it.
    pub fn allow(&mut self, directives: &str) {
        directives.clone_into(&mut self.runs);
    }
}

/// A finished text as a value, for lists and maps.
pub fn finished(text: &str) -> Value {
    Value::safe_string(text)
}

/// A map of finished texts.
pub fn texts<const N: usize>(pairs: [(&str, &str); N]) -> Value {
    with(pairs, [])
}

/// A map of finished texts, and of values.
pub fn with<const N: usize, const M: usize>(texts: [(&str, &str); N], values: [(&str, Value); M]) -> Value {
    map(texts.map(|(name, text)| (name, finished(text))).into_iter().chain(values))
}

/// A map of finished values.
pub fn map<'a>(pairs: impl IntoIterator<Item = (&'a str, Value)>) -> Value {
    Value::from(pairs.into_iter().map(|(name, value)| (name.to_owned().into(), value)).collect::<Map>())
}

/// A list.
pub fn list(values: impl IntoIterator<Item = Value>) -> Value {
    Value::from(values.into_iter().collect::<Vec<_>>())
}

impl Templates {
    /// The built-in templates of a language, with those of `own` (name relative to the folder, path for messages, text)
    /// put over them. All faults come at once. Errors: templates that cannot be read, each with its file, line and column.
    pub fn new(language: &str, own: &[(String, String, String)]) -> Result<Self, Findings> {
        let mut faults = Findings::default();
        let (mut files, mut all_metered) = (BTreeMap::new(), BTreeMap::new());
        let mut engines = Vec::with_capacity(ENGINES.len());
        for (end, escape) in ENGINES {
            let mut engine = engine();
            engine.autoescape_on([end]);
            engine.set_escape_fn(escape);
            let mine = |name: &str| own.iter().any(|(o, _, _)| o == name);
            let brought = built_in(language).filter(|(n, _)| n.ends_with(end) && !mine(n));
            let given = own.iter().filter(|(n, _, _)| n.ends_with(end));
            // Texts before those that include them: a file may include its neighbours in any order.
            let mut left: Vec<(&str, Option<&str>, &str)> =
                brought.map(|(name, text)| (name, None, text)).collect();
            left.extend(given.map(|(name, path, text)| (name.as_str(), Some(path.as_str()), text.as_str())));
            loop {
                let before = left.len();
                let mut errors = Vec::new();
                left.retain(|(name, path, text)| {
                    // What the program brought along is not metered.
                    let added = match path {
                        Some(_) => add(&mut engine, name, text),
                        None => engine.add_raw_template(name, text).map(|()| None).map_err(|e| finding(&e)),
                    };
                    match added {
                        Ok(metered) => {
                            files.extend(path.map(|path| ((*name).to_owned(), path.to_owned())));
                            all_metered.extend(metered.map(|m| ((*name).to_owned(), m)));
                            false
                        }
                        Err(error) => {
                            errors.push(error.in_file(path.unwrap_or(name)));
                            true
                        }
                    }
                });
                if left.is_empty() || left.len() == before {
                    faults.extend(errors);
                    break;
                }
            }
            engines.push((end, engine));
        }
        if faults.is_empty() {
            Ok(Self { engines, files, within: BTreeMap::new(), metered: all_metered })
        } else {
            Err(faults)
        }
    }

    /// The built-in English ones.
    ///
    /// # Panics
    /// A built-in template that cannot be read is a bug, found by any test.
    pub fn english() -> Self {
        match Self::new("en", &[]) {
            Ok(templates) => templates,
            Err(faults) => panic!("a built-in template cannot be read: {faults:?}"),
        }
    }

    /// Templates that the program alone writes: name, text. In those of XML texts are escaped. Errors: one cannot be read.
    pub fn of_program(texts: &[(String, String)]) -> Result<Self, Findings> {
        let mut engine = engine();
        engine.autoescape_on([".xml"]);
        engine.set_escape_fn(escape_html);
        for (name, text) in texts {
            engine.add_raw_template(name, text).map_err(|e| finding(&e).in_file(name))?;
        }
        let (files, within, metered) = Default::default();
        Ok(Self { engines: vec![("", engine)], files, within, metered })
    }

    /// The engine of a name; that of Markdown for names without an ending, which stand in a bank.
    fn engine(&self, name: &str) -> &Tera {
        let found = self.engines.iter().find(|(end, _)| name.ends_with(end));
        &found.unwrap_or(&self.engines[0]).1
    }

    /// Adds a Markdown template that stands inside another file (a bank), under a name of its own, which is its field there.
    /// Errors: it cannot be read.
    pub fn add_markdown(
        &mut self,
        name: &str,
        text: &str,
        place: Option<TemplatePlace>,
    ) -> Result<(), Finding> {
        match place {
            Some(place) => self.within.insert(name.to_owned(), place),
            None => self.within.remove(name),
        };
        let (_, engine) = &mut self.engines[0];
        let added = add(engine, name, text).map_err(|f| self.placed(f, name))?;
        self.metered.remove(name);
        self.metered.extend(added.map(|metered| (name.to_owned(), metered)));
        Ok(())
    }

    /// Is there a Markdown template of this name?
    pub fn has_markdown(&self, name: &str) -> bool {
        self.engines[0].1.contains_template(name)
    }

    /// The variables that a template uses at its top level, sorted. Errors: there is none of this name.
    pub fn variables(&self, name: &str) -> Result<Vec<String>, Finding> {
        names_of(self.engine(name), name).map_err(|e| self.fault(&e, name, false))
    }

    /// What a template comes to. Errors: as [`Templates::render`].
    pub fn made(&self, name: &str, view: &View) -> Result<Vec<u8>, Finding> {
        let mut out = Vec::new();
        self.render(name, view, &mut out)?;
        Ok(out)
    }
    /// What a template of Markdown comes to, with one line end at its end. Errors: as [`Templates::render`].
    pub fn markdown(&self, name: &str, view: &View) -> Result<String, Finding> {
        Ok(String::from_utf8_lossy(&self.made(name, view)?).trim_end().to_owned() + "\n")
    }
    /// Appends the text of a template to `out`; its name says which format it is.
    /// Errors: a name that the view does not hold, with file, line and column.
    pub fn render(&self, name: &str, view: &View, out: &mut Vec<u8>) -> Result<(), Finding> {
        metered::begin(view.size);
        let from = out.len();
        let writer = metered::MeteredWriter(out);
        let written = self.engine(name).render_to(name, &view.context, writer);
        written.map_err(|e| self.fault(&e, name, metered::is_over()))?;
        if name.ends_with(".html") {
            close_to_outside(out, from, &view.runs);
        }
        Ok(())
    }

    /// The file that stands in the place of a built-in template, or adds one.
    pub fn own_file(&self, name: &str) -> Option<&str> {
        self.files.get(name).map(String::as_str)
    }

    /// What went wrong with a template, `over` its budget or otherwise; the place may be in another one that it includes.
    fn fault(&self, error: &tera::Error, name: &str, over: bool) -> Finding {
        let mut fault = finding(error);
        let mut name = name;
        if let ErrorKind::SyntaxError(report) | ErrorKind::RenderingError(report) = error.kind() {
            let known = |n: &str| self.engines.iter().any(|(_, engine)| engine.contains_template(n));
            name = Some(report.filename()).filter(|n| known(n)).unwrap_or(name);
            if let (Some(metered), Some((line, column))) = (self.metered.get(name), fault.at) {
                fault.at = Some((line, metered.column(line, column.saturating_sub(1)) + 1));
            }
        }
        if over {
            fault.message = format!("template: {}", metered::SPENT);
            fault.hint = Some(metered::SPENT_HINT.to_owned());
        }
        self.placed(fault, name)
    }

    /// A finding with its file: one within a text that stands in another file keeps both places.
    fn placed(&self, mut fault: Finding, name: &str) -> Finding {
        let Some((file, line, column)) = self.within.get(name) else {
            return fault.in_file(self.files.get(name).map_or(name, String::as_str));
        };
        if let Some((line, column)) = fault.at {
            fault.message.push_str(&format!(" (line {line}, column {column} of the text)"));
        }
        name.clone_into(&mut fault.field);
        fault.at(*line, *column).in_file(file)
    }
}

/// What a page may fetch and run: nothing but its own styles, and pictures within it.
pub const CONTENT_SECURITY_POLICY: &str = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; \
     style-src 'unsafe-inline'; font-src data:; img-src data:; base-uri 'none'; form-action 'none'\">";

/// Puts the policy at the head of the page that begins here, whoever wrote its template: into the tag of the head if nothing but a
/// document type, comments and `<html>` come before, else before all that could act.
fn close_to_outside(page: &mut Vec<u8>, from: usize, runs: &str) {
    let text = String::from_utf8_lossy(page.get(from..).unwrap_or_default());
    let at = from + head_of(&text);
    // A template of somebody's own may leave the program of a sheet out.
    let runs = if text.contains("<script") { runs } else { "" };
    let line = format!("\n{}", CONTENT_SECURITY_POLICY.replacen("'none'; ", &format!("'none'; {runs}"), 1));
    page.splice(at..at, line.bytes());
}

/// Where the head of a page begins, behind its tag; behind the document type, or at the begin, if it has none.
fn head_of(page: &str) -> usize {
    let mut rest = page.trim_start_matches(|c: char| c.is_whitespace() || c == '\u{feff}');
    let begins = |rest: &str, with: &str| {
        let behind = rest.get(with.len()..).unwrap_or_default();
        rest.get(..with.len()).is_some_and(|b| b.eq_ignore_ascii_case(with))
            && (with == "<!--" || behind.starts_with(|c: char| c == '>' || c.is_ascii_whitespace()))
    };
    let mut best = 0;
    loop {
        let is_head = begins(rest, "<head");
        let behind = if begins(rest, "<!--") {
            // `<!-->` and `<!--->` are comments, too, and `--!>` ends one.
            let short = ["<!-->", "<!--->"].iter().find(|s| rest.starts_with(**s)).map(|s| s.len());
            short.or_else(|| ["-->", "--!>"].iter().filter_map(|end| Some(rest.find(end)? + end.len())).min())
        } else if is_head || begins(rest, "<html") || begins(rest, "<!doctype") {
            tag_end(rest)
        } else {
            None
        };
        let Some(after) = behind.and_then(|at| rest.get(at..)) else { return best };
        let is_type = begins(rest, "<!doctype");
        let at = page.len() - after.len();
        if is_head {
            return at;
        }
        if is_type && best == 0 {
            best = at;
        }
        rest = after.trim_start();
    }
}

/// Behind the `>` that ends the tag; one within quotes does not.
fn tag_end(tag: &str) -> Option<usize> {
    let mut quote = None;
    for (at, c) in tag.char_indices() {
        match quote {
            Some(q) if c == q => quote = None,
            Some(_) => {}
            None if c == '>' => return Some(at + 1),
            None if matches!(c, '"' | '\'') => quote = Some(c),
            None => {}
        }
    }
    None
}

/// An engine with the filters and functions that templates have.
fn engine() -> Tera {
    let mut engine = Tera::default();
    metered::equip(&mut engine);
    engine
}

/// Adds a template that the program did not bring along, with its meter if it needs one.
fn add(engine: &mut Tera, name: &str, text: &str) -> Result<Option<Metered>, Finding> {
    let metered = metered::metered(text)?;
    // As it was written first: what is wrong is told of that.
    engine.add_raw_template(name, text).map_err(|e| finding(&e))?;
    if let Some(metered) = &metered {
        let added = engine.add_raw_template(name, &metered.text);
        added.map_err(|e| {
            let mut fault = finding(&e);
            fault.at = fault.at.map(|(line, column)| (line, metered.column(line, column - 1) + 1));
            fault
        })?;
    }
    Ok(metered)
}

/// The variables that a Markdown template uses at its top level, sorted; findings have the place within the text.
pub fn variables_of(text: &str) -> Result<Vec<String>, Findings> {
    let mut engine = engine();
    add(&mut engine, "text.md", text)?;
    Ok(names_of(&engine, "text.md").map_err(|e| finding(&e))?)
}

fn names_of(engine: &Tera, template: &str) -> Result<Vec<String>, tera::Error> {
    let mut names: Vec<String> =
        engine.get_template_variables(template)?.into_iter().map(str::to_owned).collect();
    names.sort_unstable();
    Ok(names)
}

/// What is wrong, with line and column in the text of the template.
fn finding(error: &tera::Error) -> Finding {
    // A message may hold a value, of any length.
    let short = |text: String| match text.char_indices().nth(400) {
        Some((end, _)) => format!("{} ...", &text[..end]),
        None => text,
    };
    match error.kind() {
        ErrorKind::SyntaxError(report) | ErrorKind::RenderingError(report) => {
            let span = report.span();
            let message = short(format!("template: {}", report.message().trim()));
            Finding::new("", message).at(span.start_line, span.start_col + 1)
        }
        other => Finding::new("", short(format!("template: {other}"))),
    }
}

/// Escapes what Markdown (with math) would take for markup.
fn escape_markdown(text: &str, out: &mut dyn io::Write) -> io::Result<()> {
    let mut buffer = [0u8; 4];
    for c in text.chars() {
        match c {
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '+' | '!' | '|' | '$'
            | '&' | '~' => {
                out.write_all(b"\\")?;
                out.write_all(c.encode_utf8(&mut buffer).as_bytes())?;
            }
            '\n' | '\r' => out.write_all(b" ")?,
            c => out.write_all(c.encode_utf8(&mut buffer).as_bytes())?,
        }
    }
    Ok(())
}

fn escaped(text: &str, escape: fn(&str, &mut dyn io::Write) -> io::Result<()>) -> String {
    let mut out = Vec::with_capacity(text.len() + 8);
    // Writing to memory cannot fail.
    let _ = escape(text, &mut out);
    String::from_utf8_lossy(&out).into_owned()
}

/// A text escaped for Markdown.
pub fn in_markdown(text: &str) -> String {
    escaped(text, escape_markdown)
}

/// Escapes what HTML would take for markup.
fn escape_html(text: &str, out: &mut dyn io::Write) -> io::Result<()> {
    let mut buffer = [0u8; 4];
    for c in text.chars() {
        let written = match c {
            '&' => "&amp;",
            '<' => "&lt;",
            '>' => "&gt;",
            '"' => "&quot;",
            '\'' => "&#39;",
            c => c.encode_utf8(&mut buffer),
        };
        out.write_all(written.as_bytes())?;
    }
    Ok(())
}

/// A text escaped for HTML.
pub fn in_html(text: &str) -> String {
    escaped(text, escape_html)
}

/// Escapes what LaTeX would take for a command; signs that pdfLaTeX lacks are written in math, or by their number.
fn escape_tex(text: &str, out: &mut dyn io::Write) -> io::Result<()> {
    let mut buffer = [0u8; 4];
    let mut before = ' ';
    for c in text.chars() {
        let written = match c {
            '\\' => r"\textbackslash{}",
            '{' => r"\{",
            '}' => r"\}",
            '$' => r"\$",
            '&' => r"\&",
            '#' => r"\#",
            '%' => r"\%",
            '_' => r"\_",
            '^' => r"\textasciicircum{}",
            '~' => r"\textasciitilde{}",
            '<' => r"\textless{}",
            '>' => r"\textgreater{}",
            '|' => r"\textbar{}",
            '"' => r"\textquotedbl{}",
            '`' => r"\textasciigrave{}",
            // LaTeX would make one sign of two.
            '-' if before == '-' => "{}-",
            '\'' if before == '\'' => "{}'",
            '\u{a0}' => "~",
            '\u{202f}' => r"\,",
            '²' => r"\textsuperscript{2}",
            '³' => r"\textsuperscript{3}",
            '·' => r"\textperiodcentered{}",
            '°' => r"\textdegree{}",
            '×' => r"$\times$",
            '\u{2212}' => "$-$",
            '≤' => r"$\le$",
            '≥' => r"$\ge$",
            '≈' => r"$\approx$",
            '→' => r"$\to$",
            'α' => r"$\alpha$",
            'θ' => r"$\theta$",
            'μ' | 'µ' => r"$\mu$",
            'φ' => r"$\phi$",
            'ω' => r"$\omega$",
            c if c.is_control() => " ",
            ' '..='~' | '¡'..='ž' | '–' | '—' | '‘' | '’' | '‚' | '“' | '”' | '„' | '…' | '€' => {
                c.encode_utf8(&mut buffer)
            }
            c => {
                write!(out, r"\othersign{{{:04X}}}{{{c}}}", u32::from(c))?;
                ""
            }
        };
        before = c;
        out.write_all(written.as_bytes())?;
    }
    Ok(())
}

/// A text escaped for LaTeX.
pub fn in_tex(text: &str) -> String {
    escaped(text, escape_tex)
}
