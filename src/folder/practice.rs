//! Problems to practise with, as one page that works offline: boxes and hints as on a sheet, a worked solution on request, and what
//! was missed comes again. Nothing of it is graded, so the solutions lie in the page.
use crate::bank::Problem;
use crate::finding::{Finding, Findings};
use crate::folder::banks::Loaded;
use crate::inspect::table::unsatisfiable;
use crate::problem::maker::{Maker, Variant};
use crate::sheet::document::Document;
use crate::sheet::html::{self, Converter, PlaceInPage};
use crate::sheet::public;
use crate::sheet::self_check::{Handed, Hosting, SelfCheck, Use};
use crate::sheet::sheets::{SheetScratch, Sheets};
use crate::sheet::texts::Texts;
use crate::solution;

/// Name of the set that practice is drawn for.
pub const SET: &str = "practice";

/// What is on the page.
pub struct PracticePlan<'p> {
    /// The bank.
    pub loaded: &'p Loaded,
    /// Templates and phrases.
    pub texts: &'p Texts,
    /// Problems, as indices.
    pub problems: &'p [usize],
    pub seed: u64,
    /// How many variants of each problem.
    pub variants: u32,
}

/// The variant of each problem in one round of practice, the same on the page and in a terminal. Errors: no draw holds the rules
/// of the problem.
pub fn drawn(loaded: &Loaded, maker: &Maker, round: usize) -> Result<Variant, Finding> {
    maker.variant(&format!("round {round}")).map_err(|none| unsatisfiable(&loaded.bank, &none))
}

/// The page. The problems follow each other round by round. Errors: the bank leaves no scene in a page, a problem cannot be
/// drawn, or a template is faulty.
pub fn page(plan: &PracticePlan) -> Result<Vec<u8>, Findings> {
    let PracticePlan { loaded, texts, problems, seed, variants } = *plan;
    let (bank, templates, words) = (&loaded.bank, &texts.templates, &texts.words);
    if !bank.self_check {
        let fault = Finding::new("self check", "is `off`, and a page to practise with solves its scenes");
        return Err(fault.in_file(&loaded.file).hint("practise in the terminal, without --page").into());
    }
    if !templates.variables("sheet.html")?.iter().any(|v| v == "check") {
        let fault = Finding::new("sheet.html", "has no place for what checks answers");
        return Err(fault.hint("include page.html, as the built-in template does").into());
    }
    let rounds = 1..=variants as usize;
    let all: Vec<usize> = rounds.clone().flat_map(|_| problems.iter().copied()).collect();
    let of = |index: &usize| &bank.problems[*index];
    let makers: Vec<Maker> = problems.iter().map(|p| Maker::new(of(p), seed, SET)).collect();
    let variants = rounds.flat_map(|round| makers.iter().map(move |maker| drawn(loaded, maker, round)));
    let variants: Vec<Variant> = variants.collect::<Result<_, _>>()?;
    let sheets = Sheets::new(templates, words, bank, SET, &all)?;
    let (mut scratch, mut converter) = (SheetScratch::default(), Converter::new(words));
    let (head, around) = sheets.document("", "", &[], &mut scratch)?;
    let head = crate::sheet::document::Head { code: sheets.head("", "", &variants).code, ..head };
    let sheet = public::Writer::new(bank, &loaded.text, &all, SET, words.language())?.text("", &variants);
    let handed = Handed { head: &head, folder: SET, sheet: &sheet, variants: &variants };
    let tools = SelfCheck::new(words, Hosting::Single, Use::Practice).tools(bank, &all, &handed)?;
    let mut styles = Vec::new();
    let mut tasks = String::new();
    for (i, (index, variant)) in all.iter().zip(&variants).enumerate() {
        let number = i + 1;
        let own = format!("{number}.");
        let boxes: Vec<String> = tools.parts.iter().filter(|part| part.starts_with(&own)).cloned().collect();
        let mut body = |document: &Document, begin: &str, lower: usize, boxes: &[String]| {
            let prefix = format!("{begin}{number}-");
            let html =
                converter.body(document, &document.screens(), PlaceInPage { lower, prefix: &prefix, boxes });
            html::styles_once(html.trim_end(), &mut styles)
        };
        let heading = format!("## {number}. {}\n\n", of(index).title);
        let task = body(&sheets.problem_document(i, &heading, variant, &mut scratch)?, "p", 0, &boxes);
        let problem: &Problem = of(index);
        let worked = body(&solution::document(problem, variant, number, words, templates)?, "w", 1, &[]);
        let summary = words.get("page.worked");
        tasks.push_str(&format!(
            "<section class=\"task\">\n{task}\n<details><summary>{summary}</summary>\n{worked}\n</details>\n</section>\n"
        ));
    }
    // The problems stand before what is said about answers.
    let around = converter.body(&around, &[], PlaceInPage::default());
    let (before, after) = around.split_at(around.find("<hr>").unwrap_or(around.len()));
    let body = format!("{before}{tasks}{after}");
    Ok(html::page(templates, words, SET, &head, &body, Some(&tools))?)
}
