//! What is said about wrong methods: words by id, data in `banks/misconceptions.yaml` (other languages:
//! `templates/LANGUAGE/misconceptions.yaml`, with the same ids).
use crate::bank::node::{Faults, Fields, Node, named};
use crate::bank::yaml;
use crate::finding::Findings;
use crate::misconception::MethodWords;
use std::sync::LazyLock;

/// The words of one wrong method.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CatalogueEntry {
    /// Id, such as `A05`.
    pub id: String,
    /// What the student did.
    pub did: String,
    /// Why it tempts.
    pub tempts: String,
    /// How to see that it is wrong.
    pub see: String,
    /// A hint that does not give the answer away.
    pub hint: String,
    /// A note for the class report.
    pub note: String,
}

impl CatalogueEntry {
    /// The words that hints use.
    pub fn words(&self) -> MethodWords<'_> {
        MethodWords { did: &self.did, see: &self.see, hint: &self.hint }
    }
}

/// All of them, in the order of the file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Catalogue {
    entries: Vec<CatalogueEntry>,
}

/// The built-in ones: code of the language, file, text.
const LANGUAGES: &[(&str, &str, &str)] = &[
    ("en", "banks/misconceptions.yaml", include_str!("../../banks/misconceptions.yaml")),
    ("de", "templates/de/misconceptions.yaml", include_str!("../../templates/de/misconceptions.yaml")),
];

/// The built-in ones, read once: the language, and its catalogue.
static READ: LazyLock<Vec<(&str, Catalogue)>> =
    LazyLock::new(|| LANGUAGES.iter().filter_map(|(code, ..)| Some((*code, Catalogue::of(code)?))).collect());

impl Catalogue {
    /// The built-in one of a language for good; in English if there is none of this code.
    pub fn shared(language: &str) -> &'static Self {
        let (_, catalogue) = READ.iter().find(|(code, _)| *code == language).unwrap_or(&READ[0]);
        catalogue
    }

    /// The built-in one of a language (a code such as `de`); `None` if there is none.
    ///
    /// # Panics
    /// It cannot be read: a bug, found by any test.
    pub fn of(language: &str) -> Option<Self> {
        let (_, file, text) = LANGUAGES.iter().find(|(code, ..)| *code == language)?;
        match Self::read(text, file) {
            Ok(catalogue) => Some(catalogue),
            Err(faults) => panic!("the built-in catalogue cannot be read: {faults:?}"),
        }
    }

    /// Reads a catalogue: `A05: {did: ..., tempts: ..., see: ..., hint: ..., note: ...}`. Errors: all that is wrong with it.
    pub fn read(text: &str, file: &str) -> Result<Self, Findings> {
        let tree = yaml::tree(text).map_err(|f| f.in_file(file))?;
        let faults = Faults::default();
        let entries = named(&tree, "wrong methods by id", &faults)
            .into_iter()
            .filter_map(|(id, _, node)| entry(id, node, &faults))
            .collect();
        faults.into_sorted(file).into_result(Self { entries })
    }

    /// The words of a method.
    pub fn get(&self, id: &str) -> Option<&CatalogueEntry> {
        self.entries.iter().find(|e| e.id == id)
    }

    /// All of them.
    pub fn entries(&self) -> &[CatalogueEntry] {
        &self.entries
    }
}

fn entry(id: &str, node: &Node, faults: &Faults) -> Option<CatalogueEntry> {
    let mut fields = Fields::open(node, "words (did, tempts, see, hint, note)", faults)?;
    let mut word = |name: &'static str, example: &str| {
        let text = fields.need(name, example).and_then(|n| n.text().map(|t| t.trim().to_owned()));
        text.filter(|t| !t.is_empty())
    };
    let did = word("did", "took the wheel for a solid disc");
    let tempts = word("tempts", "a disc is what the table gives");
    let see = word("see", "the radius of gyration is given");
    let hint = word("hint", "What does the radius of gyration tell you?");
    let note = word("note", "use the given k, not a table");
    Some(CatalogueEntry {
        id: id.to_owned(),
        did: did?,
        tempts: tempts?,
        see: see?,
        hint: hint?,
        note: note?,
    })
}
