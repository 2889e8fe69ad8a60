//! QTI 2.1 and 3.0, which differ in names alone: an item for each variant, and a test that draws one of each problem.
//!
//! A number counts within a range, written as two comparisons: a tolerance of QTI (`equal` with `toleranceMode`) is scored as 0 by
//! players that do not know it. Each part has a score of its own; `SCORE` is their sum.
use crate::export::item::{Item, ItemPart, Right};
use crate::export::package::{Manifest, Resource};
use crate::export::xml::{Attributes, Xml};
use crate::export::{Export, Fragment};
use crate::finding::Finding;
use crate::picture::svg::escaped;
use crate::set::key_file::shortest;
use std::borrow::Cow;

/// What differs between the versions.
pub struct Dialect {
    /// Namespace of items and tests.
    pub namespace: &'static str,
    /// Namespace and address of its schema.
    pub schema_location: &'static str,
    pub manifest_namespace: &'static str,
    /// Schema of the manifest and its version.
    pub schema: (&'static str, &'static str),
    /// What a manifest calls an item.
    pub item_kind: &'static str,
    /// What a manifest calls a test.
    pub test_kind: &'static str,
    /// An element of 2.1 in this version.
    pub element: fn(&str) -> Cow<'_, str>,
    /// An attribute of 2.1 in this version.
    pub attribute: fn(&str) -> Cow<'_, str>,
    /// Does the text of a feedback stand in a body of its own?
    pub content_body: bool,
}

/// QTI that is being written, in the names of 2.1.
struct Qti<'d> {
    dialect: &'d Dialect,
    xml: Xml,
}

impl Qti<'_> {
    fn element(&mut self, name: &str, attributes: Attributes, inside: impl FnOnce(&mut Self)) {
        let name = (self.dialect.element)(name);
        let names: Vec<_> = attributes.iter().map(|(a, _)| (self.dialect.attribute)(a)).collect();
        let attributes: Vec<(&str, &str)> =
            names.iter().zip(attributes).map(|(name, (_, value))| (&**name, *value)).collect();
        self.xml.begin(&name, &attributes);
        inside(self);
        self.xml.end(&name);
    }

    fn empty(&mut self, name: &str, attributes: Attributes) {
        self.element(name, attributes, |_| ());
    }

    fn text(&mut self, name: &str, attributes: Attributes, text: &str) {
        self.element(name, attributes, |q| q.xml.raw(&escaped(text)));
    }

    /// A variable that an item tells, with its value at the start.
    fn outcome(&mut self, name: &str, start: f64, most: Option<f64>) {
        let most = most.map(shortest);
        let mut attributes = vec![("identifier", name), ("cardinality", "single"), ("baseType", "float")];
        attributes.extend(most.as_deref().map(|most| ("normalMaximum", most)));
        self.element("outcomeDeclaration", &attributes, |q| {
            q.element("defaultValue", &[], |q| q.text("value", &[], &shortest(start)));
        });
    }

    /// Sets a variable to a number.
    fn set(&mut self, name: &str, number: f64) {
        self.element("setOutcomeValue", &[("identifier", name)], |q| {
            q.text("baseValue", &[("baseType", "float")], &shortest(number));
        });
    }
}

fn score(part: &ItemPart) -> String {
    format!("SCORE-{}", part.id)
}

fn address(file: &str) -> String {
    format!("../{}", path(file))
}

fn path(file: &str) -> String {
    format!("figures/{file}")
}

fn item_path(id: &str) -> String {
    format!("items/{id}.xml")
}

/// XHTML whose formulas say that they are MathML, as XML wants it and HTML does not.
fn with_mathml(xhtml: &str) -> String {
    xhtml.replace("<math ", "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" ")
}

/// The name of an item.
fn name(problem: usize, code: &str) -> String {
    format!("p{}-{code}", problem + 1)
}

/// The item of a variant.
pub fn fragment(dialect: &Dialect, export: &Export, item: &Item) -> Fragment {
    let id = name(item.problem, &item.code);
    let mut q = Qti { dialect, xml: Xml::file() };
    let title = format!("{} {}", item.title, item.code);
    let attributes = [
        ("xmlns", dialect.namespace),
        ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
        ("xsi:schemaLocation", dialect.schema_location),
        ("identifier", &id),
        ("title", &title),
        ("adaptive", "false"),
        ("timeDependent", "false"),
        ("xml:lang", export.language),
    ];
    q.element("assessmentItem", &attributes, |q| {
        declare(q, item);
        q.element("itemBody", &[], |q| {
            let text = item.text(None, &mut |i| interaction(dialect, &item.parts[i]), &address);
            q.xml.raw(&with_mathml(&text));
        });
        process(q, item);
        if let Some(solution) = item.solution(&address) {
            let feedback =
                [("outcomeIdentifier", "FEEDBACK"), ("identifier", "solution"), ("showHide", "show")];
            q.element("modalFeedback", &feedback, |q| match dialect.content_body {
                true => q.element("contentBody", &[], |q| q.xml.raw(&with_mathml(&solution))),
                false => q.xml.raw(&with_mathml(&solution)),
            });
        }
    });
    q.xml.line();
    let mut files = vec![(item_path(&id), q.xml.done().into_bytes())];
    files.extend(item.pictures.iter().map(|p| (path(&p.file), p.svg.clone().into_bytes())));
    Fragment { problem: item.problem, code: item.code.clone(), questions: vec![id], files }
}

/// Answers and outcomes of an item.
fn declare(q: &mut Qti, item: &Item) {
    for part in &item.parts {
        let id = part.id.as_str();
        let (kind, right) = match &part.right {
            Right::Number { value, .. } => ("float", shortest(*value)),
            Right::Word { right, .. } => ("identifier", (*right).to_owned()),
        };
        let attributes = [("identifier", id), ("cardinality", "single"), ("baseType", kind)];
        q.element("responseDeclaration", &attributes, |q| {
            q.element("correctResponse", &[], |q| q.text("value", &[], &right));
        });
    }
    q.outcome("SCORE", 0.0, Some(item.points()));
    q.outcome("MAXSCORE", item.points(), None);
    for part in &item.parts {
        q.outcome(&score(part), 0.0, Some(part.points));
    }
    if item.solution.is_some() {
        q.empty(
            "outcomeDeclaration",
            &[("identifier", "FEEDBACK"), ("cardinality", "single"), ("baseType", "identifier")],
        );
    }
}

/// The place for the answer to a part.
fn interaction(dialect: &Dialect, part: &ItemPart) -> String {
    let mut q = Qti { dialect, xml: Xml::piece() };
    let id = part.id.as_str();
    match &part.right {
        Right::Number { .. } => {
            q.empty("textEntryInteraction", &[("responseIdentifier", id), ("expectedLength", "12")]);
        }
        Right::Word { offered, .. } => {
            let attributes = [("responseIdentifier", id), ("shuffle", "false")];
            q.element("inlineChoiceInteraction", &attributes, |q| {
                for (word, said) in offered {
                    q.text("inlineChoice", &[("identifier", word)], said);
                }
            });
        }
    }
    q.xml.done()
}

/// What an answer scores.
fn process(q: &mut Qti, item: &Item) {
    q.element("responseProcessing", &[], |q| {
        for part in &item.parts {
            let id = part.id.as_str();
            q.element("responseCondition", &[], |q| {
                q.element("responseIf", &[], |q| {
                    match &part.right {
                        Right::Number { value, tolerance, .. } => q.element("and", &[], |q| {
                            for (compare, bound) in [("gte", value - tolerance), ("lte", value + tolerance)] {
                                q.element(compare, &[], |q| {
                                    q.empty("variable", &[("identifier", id)]);
                                    q.text("baseValue", &[("baseType", "float")], &shortest(bound));
                                });
                            }
                        }),
                        Right::Word { right, .. } => q.element("match", &[], |q| {
                            q.empty("variable", &[("identifier", id)]);
                            q.text("baseValue", &[("baseType", "identifier")], right);
                        }),
                    }
                    q.set(&score(part), part.points);
                });
                // Whoever tries again and is wrong has no points left of the time before.
                q.element("responseElse", &[], |q| q.set(&score(part), 0.0));
            });
        }
        q.element("setOutcomeValue", &[("identifier", "SCORE")], |q| {
            q.element("sum", &[], |q| {
                for part in &item.parts {
                    q.empty("variable", &[("identifier", &score(part))]);
                }
            });
        });
        if item.solution.is_some() {
            q.element("setOutcomeValue", &[("identifier", "FEEDBACK")], |q| {
                q.text("baseValue", &[("baseType", "identifier")], "solution");
            });
        }
    });
}

/// A test: of each problem one variant is drawn.
fn test(dialect: &Dialect, export: &Export, fragments: &[Fragment]) -> String {
    let mut q = Qti { dialect, xml: Xml::file() };
    let attributes = [
        ("xmlns", dialect.namespace),
        ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
        ("xsi:schemaLocation", dialect.schema_location),
        ("identifier", "test"),
        ("title", export.set),
    ];
    q.element("assessmentTest", &attributes, |q| {
        let points = export.problems.iter().flat_map(|p| &p.questions).map(|q| q.points).sum();
        q.outcome("SCORE", 0.0, Some(points));
        let part =
            [("identifier", "part"), ("navigationMode", "nonlinear"), ("submissionMode", "simultaneous")];
        q.element("testPart", &part, |q| {
            for of_problem in fragments.chunk_by(|a, b| a.problem == b.problem) {
                let at = of_problem[0].problem;
                let (id, title) = (format!("problem-{}", at + 1), export.name(at));
                let section = [("identifier", id.as_str()), ("title", &title), ("visible", "true")];
                q.element("assessmentSection", &section, |q| {
                    q.empty("selection", &[("select", "1")]);
                    for id in of_problem.iter().flat_map(|f| &f.questions) {
                        q.empty("assessmentItemRef", &[("identifier", id), ("href", &item_path(id))]);
                    }
                });
            }
        });
        q.element("outcomeProcessing", &[], |q| {
            q.element("setOutcomeValue", &[("identifier", "SCORE")], |q| {
                q.element("sum", &[], |q| q.empty("testVariables", &[("variableIdentifier", "SCORE")]));
            });
        });
    });
    q.xml.line();
    q.xml.done()
}

/// The archive. Errors: it would be too large.
pub fn file(dialect: &Dialect, export: &Export, fragments: Vec<Fragment>) -> Result<Vec<u8>, Finding> {
    const TEST: &str = "test.xml";
    let text = test(dialect, export, &fragments).into_bytes();
    let ids = || fragments.iter().flat_map(|f| &f.questions).cloned();
    let mut resources = vec![Resource {
        id: "test".to_owned(),
        kind: dialect.test_kind.to_owned(),
        files: vec![TEST.to_owned()],
        needs: ids().collect(),
        named: true,
    }];
    resources.extend(fragments.iter().zip(ids()).map(|(fragment, id)| Resource {
        id,
        kind: dialect.item_kind.to_owned(),
        files: fragment.files.iter().map(|(path, _)| path.clone()).collect(),
        needs: Vec::new(),
        named: true,
    }));
    let mut files = vec![(TEST.to_owned(), text)];
    files.extend(fragments.into_iter().flat_map(|f| f.files));
    let manifest = Manifest {
        id: &export.id,
        namespace: dialect.manifest_namespace,
        schema: dialect.schema,
        resources: &resources,
    };
    manifest.archive(files)
}
