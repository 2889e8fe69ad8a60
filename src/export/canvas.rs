//! QTI 1.2 in an archive, as Canvas imports it: one quiz with a group of questions for each part, from which one is drawn. Canvas
//! has no question with several numbers, so each part is a question with the statement of its own.
use crate::export::item::Item;
use crate::export::{Export, Fragment, package, part_view, units};
use crate::finding::{Finding, Findings};
use crate::key::{Answer, KeyEntry, ProblemKey, SheetKey};
use crate::num;
use crate::set::key_file::shortest;
use serde_json::json;

/// Canvas keeps four decimals of a number: what is smaller becomes 0.
pub const LEAST: f64 = 1e-4;

fn address(file: &str) -> String {
    format!("%24IMS-CC-FILEBASE%24/{}", path(file))
}

fn path(file: &str) -> String {
    format!("images/{file}")
}

/// The questions of an item. Errors: faults of the template.
pub fn fragment(export: &Export, item: &Item) -> Result<Fragment, Finding> {
    let question = |(i, part): (usize, &KeyEntry)| {
        let question = json!({
            "id": format!("i{}-{}-{}", item.problem + 1, item.code, part.part),
            "code": item.code,
            "text": item.text(Some(i), &mut |_| String::new(), &address),
            "part": part_view(part, item.words),
            // A solution is long and is that of all parts: it stands with the last of them.
            "solution": if i + 1 == item.parts.len() { item.solution(&address) } else { None },
        });
        export.made("canvas-question.xml", &question)
    };
    let questions = item.parts.iter().enumerate().map(question).collect::<Result<_, _>>()?;
    let files = item.pictures.iter().map(|p| (path(&p.file), p.svg.clone().into_bytes()));
    Ok(Fragment { problem: item.problem, code: item.code.to_owned(), questions, files: files.collect() })
}

/// The parts of these problems whose numbers Canvas would take for 0 in some variant, each with the worst one.
pub fn too_small(keys: &[SheetKey], chosen: &[usize]) -> Findings {
    let mut faults = Findings::default();
    for at in chosen {
        let variants: Vec<&ProblemKey> = keys.iter().filter_map(|key| key.problems.get(*at)).collect();
        let parts = variants.first().map_or(0, |first| first.parts.len());
        for i in 0..parts {
            let worst = variants.iter().filter_map(|variant| Some((*variant, least(variant.parts.get(i)?)?)));
            if let Some((variant, least)) = worst.min_by(|a, b| a.1.total_cmp(&b.1))
                && least < LEAST
            {
                faults.push(part_too_small(variant, &variant.parts[i], least));
            }
        }
    }
    faults
}

/// The smaller of an answer and its tolerance in the unit that is asked; a 0 stays what it is.
fn least(entry: &KeyEntry) -> Option<f64> {
    let Answer::Number { value, half_width, .. } = &entry.answer else { return None };
    let sizes = [*value, *half_width].map(|x| entry.unit.from_si(x).abs());
    sizes.into_iter().filter(|x| *x > 0.0).min_by(f64::total_cmp)
}

/// The finding that names the closest unit in which the numbers of all variants are large enough.
fn part_too_small(variant: &ProblemKey, entry: &KeyEntry, least: f64) -> Finding {
    let field = format!("problems.{}.questions.{}.unit", variant.id, entry.part);
    let what = format!(
        "the answer or its tolerance is down to {} {} (data {}), too small for Canvas, which takes what is below {} for 0",
        num::shown::significant(least, 3),
        entry.unit.ascii(),
        variant.code,
        shortest(LEAST)
    );
    let larger = units::units(&entry.unit).into_iter().filter(|(_, times)| least * times >= LEAST);
    let unit = match larger.min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((name, _)) => name,
        None => "a smaller unit".to_owned(),
    };
    Finding::new(field, what).hint(format!("ask for it in {unit}, or leave the problem out with --problems"))
}

/// The archive. Errors: it would be too large.
pub fn file(export: &Export, fragments: Vec<Fragment>) -> Result<Vec<u8>, Finding> {
    let id = format!("quiz-{}", export.id);
    let (main, of_quiz) = (format!("{id}/{id}.xml"), format!("{id}/assessment_meta.xml"));
    let whole = export.whole(&id, "", &fragments);
    let mut files = vec![
        (main.clone(), export.made("canvas.xml", &whole)?.into_bytes()),
        (of_quiz.clone(), export.made("canvas-meta.xml", &whole)?.into_bytes()),
    ];
    let needed = format!("{id}-meta");
    const META: &str = "associatedcontent/imscc_xmlv1p1/learning-application-resource";
    let mut resources = vec![
        json!({"id": id, "kind": "imsqti_xmlv1p2", "files": [main], "needs": [needed], "named": false}),
        json!({"id": needed, "kind": META, "files": [of_quiz], "needs": [], "named": true}),
    ];
    for (path, bytes) in fragments.into_iter().flat_map(|f| f.files) {
        let id = format!("image-{}", resources.len());
        resources.push(json!({"id": id, "kind": "webcontent", "files": [path], "needs": [], "named": true}));
        files.push((path, bytes));
    }
    let namespace = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1";
    package::archive(export, (namespace, ["IMS Content", "1.1.3"]), &resources, files)
}
