//! Name and view to text; keeper of the Tera crate.
//!
//! Views hold finished strings: numbers, units and formulas are text already and marked as such, names of people are
//! not and are escaped for the format. A variable that does not exist is an error with its place, never an empty text.
use crate::finding::Finding;
use std::collections::BTreeMap;
use std::io;
use tera::Context;
use tera::ErrorKind;
use tera::Tera;

pub use tera::Map;
pub use tera::Value;

/// The templates that the program brings along: name, text.
pub const BUILT_IN: &[(&str, &str)] = &[
    ("sheet.md", include_str!("../templates/sheet.md")),
    ("sheet.html", include_str!("../templates/sheet.html")),
    ("accuracy.html", include_str!("../templates/accuracy.html")),
    ("questions.md", include_str!("../templates/questions.md")),
    ("solution/default.md", include_str!("../templates/solution/default.md")),
    ("statement/compound-pendulum.md", include_str!("../templates/statement/compound-pendulum.md")),
    ("statement/falling-rod.md", include_str!("../templates/statement/falling-rod.md")),
    ("statement/kinetic-energy.md", include_str!("../templates/statement/kinetic-energy.md")),
    ("statement/lifted-rod.md", include_str!("../templates/statement/lifted-rod.md")),
    ("statement/pulled-rolling.md", include_str!("../templates/statement/pulled-rolling.md")),
    ("statement/pulled-slipping.md", include_str!("../templates/statement/pulled-slipping.md")),
    ("statement/rod-and-spring.md", include_str!("../templates/statement/rod-and-spring.md")),
    ("statement/spring-released.md", include_str!("../templates/statement/spring-released.md")),
    ("statement/thrown-ball.md", include_str!("../templates/statement/thrown-ball.md")),
    ("statement/wheel-set-down.md", include_str!("../templates/statement/wheel-set-down.md")),
];

/// All templates, compiled: one engine for each format, built once and shared by all threads.
pub struct Templates {
    markdown: Tera,
    html: Tera,
    /// Where the templates given by the user came from: name to path.
    files: BTreeMap<String, String>,
}

/// What a template sees. Values put in as finished text are not escaped again.
#[derive(Clone, Default)]
pub struct View(Context);

impl View {
    /// An empty view.
    pub fn new() -> Self {
        Self::default()
    }
    /// Puts in a finished text.
    pub fn text(&mut self, name: impl Into<String>, text: &str) {
        self.0.insert_value(name.into(), Value::safe_string(text));
    }
    /// Puts in a text that somebody else wrote, to be escaped.
    pub fn foreign(&mut self, name: impl Into<String>, text: &str) {
        self.0.insert_value(name.into(), Value::normal_string(text));
    }
    /// Puts in a list or map that was made before.
    pub fn value(&mut self, name: impl Into<String>, value: Value) {
        self.0.insert_value(name.into(), value);
    }
    /// Takes a name away.
    pub fn remove(&mut self, name: &str) {
        let _ = self.0.remove(name);
    }
}

/// A finished text as a value, for lists and maps.
pub fn finished(text: &str) -> Value {
    Value::safe_string(text)
}

/// A map of finished texts.
pub fn map<'a>(pairs: impl IntoIterator<Item = (&'a str, Value)>) -> Value {
    let mut map = Map::new();
    for (name, value) in pairs {
        map.insert(name.to_owned().into(), value);
    }
    Value::from(map)
}

/// A list.
pub fn list(values: Vec<Value>) -> Value {
    Value::from(values)
}

impl Templates {
    /// The built-in templates, with those of `own` (name relative to the folder, path for messages, text) put over
    /// them. All faults come at once.
    pub fn new(own: &[(String, String, String)]) -> Result<Self, Vec<Finding>> {
        let mut markdown = Tera::default();
        markdown.autoescape_on([".md"]);
        markdown.set_escape_fn(escape_markdown);
        let mut html = Tera::default();
        html.autoescape_on([".html"]);
        let mut faults = Vec::new();
        let mut files = BTreeMap::new();
        let built_in = BUILT_IN.iter().filter(|(n, _)| !own.iter().any(|(o, _, _)| o == n));
        for (name, text) in built_in {
            let engine = if name.ends_with(".html") { &mut html } else { &mut markdown };
            if let Err(error) = engine.add_raw_template(name, text) {
                faults.push(finding(&error, name, None));
            }
        }
        // Texts before those that include them: a file may include its neighbours in any order.
        for wanted in ["md", "html"] {
            let mut left: Vec<_> =
                own.iter().filter(|(n, _, _)| n.rsplit('.').next() == Some(wanted)).collect();
            let engine = if wanted == "html" { &mut html } else { &mut markdown };
            loop {
                let before = left.len();
                let mut errors = Vec::new();
                left.retain(|(name, path, text)| match engine.add_raw_template(name, text) {
                    Ok(()) => {
                        files.insert(name.clone(), path.clone());
                        false
                    }
                    Err(error) => {
                        errors.push(finding(&error, path, None));
                        true
                    }
                });
                if left.is_empty() || left.len() == before {
                    faults.extend(errors);
                    break;
                }
            }
        }
        if faults.is_empty() { Ok(Self { markdown, html, files }) } else { Err(faults) }
    }

    /// Adds a Markdown template that stands inside another file (a bank), under a name of its own.
    pub fn add_markdown(&mut self, name: &str, text: &str) -> Result<(), Finding> {
        self.markdown.add_raw_template(name, text).map_err(|e| finding(&e, name, None))
    }

    /// Is there a Markdown template of this name?
    pub fn has_markdown(&self, name: &str) -> bool {
        self.markdown.contains_template(name)
    }

    /// The variables that a Markdown template uses at its top level, sorted.
    pub fn variables(&self, name: &str) -> Result<Vec<String>, Finding> {
        let names = self.markdown.get_template_variables(name).map_err(|e| finding(&e, name, None))?;
        let mut names: Vec<String> = names.into_iter().map(str::to_owned).collect();
        names.sort_unstable();
        Ok(names)
    }

    /// Appends the text of a Markdown template to `out`.
    pub fn markdown(&self, name: &str, view: &View, out: &mut Vec<u8>) -> Result<(), Finding> {
        self.markdown.render_to(name, &view.0, out).map_err(|e| finding(&e, self.path(name), None))
    }

    /// Appends the text of an HTML template to `out`.
    pub fn html(&self, name: &str, view: &View, out: &mut Vec<u8>) -> Result<(), Finding> {
        self.html.render_to(name, &view.0, out).map_err(|e| finding(&e, self.path(name), None))
    }

    /// The file that stands in the place of a built-in template, or adds one.
    pub fn own_file(&self, name: &str) -> Option<&str> {
        self.files.get(name).map(String::as_str)
    }

    fn path<'a>(&'a self, name: &'a str) -> &'a str {
        self.files.get(name).map_or(name, String::as_str)
    }
}

/// The variables that a Markdown template uses at its top level, sorted; findings have the place within the text.
pub fn variables_of(text: &str) -> Result<Vec<String>, Vec<Finding>> {
    let mut tera = Tera::default();
    tera.add_raw_template("text.md", text).map_err(|e| vec![finding(&e, "", Some(()))])?;
    let names = tera.get_template_variables("text.md").map_err(|e| vec![finding(&e, "", Some(()))])?;
    let mut names: Vec<String> = names.into_iter().map(str::to_owned).collect();
    names.sort_unstable();
    Ok(names)
}

fn finding(error: &tera::Error, file: &str, inner: Option<()>) -> Finding {
    let finding = match error.kind() {
        ErrorKind::SyntaxError(report) | ErrorKind::RenderingError(report) => {
            let span = report.span();
            Finding::new("", format!("template: {}", report.message().trim()))
                .at(span.start_line, span.start_col + 1)
        }
        other => Finding::new("", format!("template: {other}")),
    };
    if inner.is_some() || file.is_empty() { finding } else { finding.in_file(file) }
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
