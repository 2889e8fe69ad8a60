//! A sheet as a page that checks itself: boxes for answers, what the page must know, and the program in WebAssembly that answers.
//! It knows no key: the scene is solved in the page, with the functions of [`crate::page`].
use crate::bank::{Bank, Problem};
use crate::finding::Finding;
use crate::misconception::catalogue::{Catalogue, CatalogueEntry};
use crate::page::check::{PosedProblem, Unsolved};
use crate::page::sheet_file::{SheetFile, SheetProblem};
use crate::policy::Hints;
use crate::problem::make_key;
use crate::problem::maker::Variant;
use crate::sheet::document::Head;
use crate::template;
use crate::words::Words;
use base64::prelude::{BASE64_STANDARD, Engine as _};
use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};
use serde_json::json;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

/// The program of the page, packed with gzip; `.ci/page` makes it from `src/page`.
pub const PROGRAM: &[u8] = include_bytes!("../../templates/page/check.wasm.gz");
/// What keeps sheets of a site for when there is no network.
pub const WORKER: &str = include_str!("../../templates/page/sw.js");
const SCRIPT: &str = include_str!("../../templates/page/page.js");
/// The phrases that the page needs, by the begins of their names: those of judging, which `slipstick check` takes from the built-in
/// lists alone, and those that stand on the page and may be one's own.
const JUDGING: [&str; 3] = ["feedback", "sheet", "tutor"];
const ON_THE_PAGE: [&str; 2] = ["page", "report.verdict"];

static PACKED: LazyLock<String> = LazyLock::new(|| BASE64_STANDARD.encode(PROGRAM));
/// Name of the program where it lies beside sheets. A sheet needs the very program with which it was made: others may lie beside it.
pub static PROGRAM_NAME: LazyLock<String> = LazyLock::new(|| {
    let digest = Sha256::digest(PROGRAM);
    format!("check-{:02x}{:02x}{:02x}{:02x}.wasm.gz", digest[0], digest[1], digest[2], digest[3])
});
/// The script by its hash, so that no other runs.
static HASH: LazyLock<String> = LazyLock::new(|| BASE64_STANDARD.encode(Sha256::digest(SCRIPT.as_bytes())));

worded! {
    /// Where the program of a page lies.
    #[derive(Default, Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    Hosting {
        /// In each sheet, which is then one file that needs nothing else
        #[default]
        Single "single",
        /// Beside the sheets, once for all, for a web server
        Site "site",
    }
}

/// What a page is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// Answers are saved and handed in.
    Sheet,
    /// One problem follows another; nothing is handed in.
    Practice,
}

/// What all pages of a set have in common.
pub struct SelfCheck<'t> {
    words: &'t Words,
    hosting: Hosting,
    used: Use,
    phrases: serde_json::Value,
    /// The problems that were read, by their index in the bank and their case.
    read: Mutex<FxHashMap<(usize, usize), Arc<PosedProblem>>>,
}

/// What stands in a page besides the document.
pub struct Tools {
    /// What the page may do, as directives of its Content Security Policy.
    pub policy: String,
    /// What `page.html` sees: words for its buttons, data, program and script.
    pub view: template::Value,
    /// The parts that have a box.
    pub parts: Vec<String>,
}

/// A sheet on its way to become a page: who gets it, and the texts of its files.
pub struct Handed<'h> {
    /// Head of the sheet.
    pub head: &'h Head,
    /// Folder of the student, which names the file of answers.
    pub folder: &'h str,
    /// The text of sheet.json.
    pub sheet: &'h str,
    /// What was drawn, in the order of the sheet.
    pub variants: &'h [Variant],
}

impl<'t> SelfCheck<'t> {
    /// Gets ready.
    pub fn new(words: &'t Words, hosting: Hosting, used: Use) -> Self {
        let mut phrases = words.phrases(&ON_THE_PAGE);
        let judging = Words::built_in(words.language()).unwrap_or(words);
        phrases.phrases.extend(judging.phrases(&JUDGING).phrases);
        Self { words, hosting, used, phrases: json!(phrases), read: Mutex::default() }
    }

    /// The tools of one sheet. Errors: the text of sheet.json is none, or not of this bank.
    pub fn tools(&self, bank: &Bank, problems: &[usize], handed: &Handed) -> Result<Tools, Finding> {
        let Handed { head, folder, sheet, variants } = handed;
        let chosen = || problems.iter().filter_map(|p| bank.problems.get(*p)).zip(*variants).enumerate();
        let (mut parts, mut words) = (Vec::new(), BTreeMap::new());
        for (i, (problem, variant)) in chosen() {
            for (index, q) in problem.questions.iter().enumerate() {
                let name = format!("{}.{}", i + 1, q.id);
                if q.label.quantity.is_word() {
                    words.insert(name.clone(), self.offered(problem, index, variant));
                }
                parts.push(name);
            }
        }
        let sheet: serde_json::Value = serde_json::from_str(sheet)
            .map_err(|e| Finding::new("sheet.json", format!("cannot be put into a page: {e}")))?;
        let file = SheetFile::of(&sheet)?;
        let problems = file.problems.iter().zip(problems.iter().zip(*variants));
        let packed = problems.map(|(sheet, (index, variant))| self.packed(sheet, (*index, variant.case)));
        let data = json!({
            "student": file.student,
            "set": file.set,
            "problems": packed.collect::<Result<Vec<_>, _>>()?,
            "program": *PROGRAM_NAME,
            "phrases": self.phrases,
            "methods": self.methods(bank, &sheet),
            "words": words,
            "file": format!("answers-{folder}.csv"),
            "keep": format!("slipstick {} {} {}", head.set, head.student, head.code),
        });
        let program = if self.hosting == Hosting::Single { PACKED.as_str() } else { "" };
        // In a script no text may look like its end.
        let data = data.to_string().replace('<', "\\u003c");
        let practice = if self.used == Use::Practice { "yes" } else { "" };
        let say = template::Value::from_serializable(&self.words.tree("page"));
        let texts = [("data", &*data), ("program", program), ("script", SCRIPT), ("practice", practice)];
        let view = template::with(texts, [("say", say)]);
        let mut policy = format!("script-src 'sha256-{}' 'wasm-unsafe-eval'; ", *HASH);
        if self.hosting == Hosting::Site {
            policy.push_str("connect-src 'self'; worker-src 'self'; ");
        }
        Ok(Tools { policy, view, parts })
    }

    /// A problem of a sheet for the page. The scene of each problem and case is read once.
    fn packed(&self, sheet: &SheetProblem, of: (usize, usize)) -> Result<String, Finding> {
        let unfit = |why: &dyn std::fmt::Display| {
            Finding::new("sheet.json", format!("cannot be put into a page: {why}"))
        };
        let read = self.read.lock().unwrap_or_else(PoisonError::into_inner).get(&of).cloned();
        let posed = match read {
            Some(posed) => posed,
            None => {
                let read = PosedProblem::read(sheet, "sheet.json").map_err(|why| match why {
                    Unsolved::Faults(faults) => unfit(&faults),
                    Unsolved::NoScene | Unsolved::Refused(..) => unfit(&"it carries no scene"),
                })?;
                let posed = Arc::new(read);
                self.read.lock().unwrap_or_else(PoisonError::into_inner).insert(of, posed.clone());
                posed
            }
        };
        posed.put_to(sheet).packed().map_err(|e| unfit(&e))
    }

    /// The words of the wrong methods that a sheet lists, as far as the bank lets its hints go.
    fn methods(&self, bank: &Bank, sheet: &serde_json::Value) -> BTreeMap<String, serde_json::Value> {
        if bank.grading.hints == Hints::None {
            return BTreeMap::new();
        }
        let catalogue = Catalogue::shared(self.words.language());
        let scenes = sheet["problems"].as_array().into_iter().flatten().map(|problem| &problem["scene"]);
        let problems = scenes.filter_map(|scene| scene["problems"].as_object()).flatten();
        let listed = problems.filter_map(|(_, problem)| problem["mistakes"].as_object()).flatten();
        // How to see that a method is wrong stands in the last hint alone.
        let all = bank.grading.hints == Hints::Explain;
        let words = |entry: &CatalogueEntry| json!({ "did": entry.did, "see": if all { entry.see.as_str() } else { "" }, "hint": entry.hint });
        listed.filter_map(|(id, _)| Some((id.clone(), words(catalogue.get(id)?)))).collect()
    }

    /// The words that answer a question in words.
    fn offered(&self, problem: &Problem, question: usize, variant: &Variant) -> Vec<String> {
        let quantity = problem.questions[question].label.quantity;
        let list = make_key::offered(problem, quantity, &problem.cases[variant.case].scene);
        list.iter().map(|word| self.words.of_key(word).to_owned()).collect()
    }
}
