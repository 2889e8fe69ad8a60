//! QTI 1.2 in an archive, as Canvas imports it: one quiz with a group of questions for each part, from which one is drawn. Canvas
//! has no question with several numbers, so each part is a question with the statement of its own.
use crate::export::item::{Item, ItemPart, Right};
use crate::export::package::{Manifest, Resource};
use crate::export::xml::Xml;
use crate::export::{Export, Fragment, units};
use crate::finding::{Finding, Findings};
use crate::key::{Answer, KeyEntry, ProblemKey, SheetKey};
use crate::num;
use crate::set::key_file::shortest;

/// Canvas keeps four decimals of a number: what is smaller becomes 0.
pub const LEAST: f64 = 1e-4;

fn address(file: &str) -> String {
    format!("%24IMS-CC-FILEBASE%24/{}", path(file))
}

fn path(file: &str) -> String {
    format!("images/{file}")
}

/// The questions of an item.
pub fn fragment(item: &Item) -> Fragment {
    let questions = (0..item.parts.len()).map(|i| question(item, i)).collect();
    let files = item.pictures.iter().map(|p| (path(&p.file), p.svg.clone().into_bytes()));
    Fragment { problem: item.problem, code: item.code.clone(), questions, files: files.collect() }
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

/// A field of the metadata of a question.
fn about(x: &mut Xml, label: &str, entry: &str) {
    x.element("qtimetadatafield", &[], |x| {
        x.text("fieldlabel", &[], label);
        x.text("fieldentry", &[], entry);
    });
}

/// HTML, which stands as a text.
fn material(x: &mut Xml, html: &str) {
    x.element("material", &[], |x| x.text("mattext", &[("texttype", "text/html")], html));
}

/// The question of a part.
fn question(item: &Item, i: usize) -> String {
    let part = &item.parts[i];
    let html = item.text(Some(i), &mut |_| String::new(), &address);
    let id = format!("i{}-{}-{}", item.problem + 1, item.code, part.id);
    let kind = match part.right {
        Right::Number { .. } => "numerical_question",
        Right::Word { .. } => "multiple_choice_question",
    };
    let mut x = Xml::piece();
    x.element("item", &[("ident", &id), ("title", &item.code)], |x| {
        x.element("itemmetadata", &[], |x| {
            x.element("qtimetadata", &[], |x| {
                about(x, "question_type", kind);
                about(x, "points_possible", &shortest(part.points));
                about(x, "assessment_question_identifierref", &format!("q-{id}"));
            });
        });
        x.element("presentation", &[], |x| {
            material(x, &html);
            let response = [("ident", "response1"), ("rcardinality", "Single")];
            match &part.right {
                Right::Number { .. } => x.element("response_str", &response, |x| {
                    x.element("render_fib", &[("fibtype", "Decimal")], |x| {
                        x.empty("response_label", &[("ident", "answer1")]);
                    });
                }),
                Right::Word { offered, .. } => x.element("response_lid", &response, |x| {
                    x.element("render_choice", &[], |x| {
                        for (word, said) in offered {
                            x.element("response_label", &[("ident", word)], |x| material(x, said));
                        }
                    });
                }),
            }
        });
        // A solution is long and is that of all parts: it stands with the last of them.
        let solution = if i + 1 == item.parts.len() { item.solution(&address) } else { None };
        processing(x, part, solution.is_some());
        if let Some(solution) = solution {
            x.element("itemfeedback", &[("ident", "general_fb")], |x| {
                x.element("flow_mat", &[], |x| material(x, &solution));
            });
        }
    });
    x.line();
    x.done()
}

/// When an answer counts.
fn processing(x: &mut Xml, part: &ItemPart, explained: bool) {
    let to = [("respident", "response1")];
    x.element("resprocessing", &[], |x| {
        x.element("outcomes", &[], |x| {
            let score =
                [("maxvalue", "100"), ("minvalue", "0"), ("varname", "SCORE"), ("vartype", "Decimal")];
            x.empty("decvar", &score);
        });
        if explained {
            x.element("respcondition", &[("continue", "Yes")], |x| {
                x.element("conditionvar", &[], |x| x.empty("other", &[]));
                x.empty("displayfeedback", &[("feedbacktype", "Response"), ("linkrefid", "general_fb")]);
            });
        }
        x.element("respcondition", &[("continue", "No")], |x| {
            x.element("conditionvar", &[], |x| match &part.right {
                Right::Number { value, tolerance, .. } => x.element("or", &[], |x| {
                    x.text("varequal", &to, &shortest(*value));
                    x.element("and", &[], |x| {
                        x.text("vargte", &to, &shortest(value - tolerance));
                        x.text("varlte", &to, &shortest(value + tolerance));
                    });
                }),
                Right::Word { right, .. } => x.text("varequal", &to, right),
            });
            x.text("setvar", &[("action", "Set"), ("varname", "SCORE")], "100");
        });
    });
}

fn quiz(export: &Export, fragments: &[Fragment], id: &str) -> String {
    let mut x = Xml::file();
    x.element("questestinterop", &[("xmlns", "http://www.imsglobal.org/xsd/ims_qtiasiv1p2")], |x| {
        x.element("assessment", &[("ident", id), ("title", export.set)], |x| {
            x.element("qtimetadata", &[], |x| about(x, "cc_maxattempts", "1"));
            x.element("section", &[("ident", "root_section")], |x| {
                x.line();
                for of_problem in fragments.chunk_by(|a, b| a.problem == b.problem) {
                    let at = of_problem[0].problem;
                    for (i, q) in export.problems[at].questions.iter().enumerate() {
                        let (ident, title) =
                            (format!("{id}-{}-{}", at + 1, q.id), format!("{}: {}", export.name(at), q.id));
                        x.element("section", &[("ident", &ident), ("title", &title)], |x| {
                            x.element("selection_ordering", &[], |x| {
                                x.element("selection", &[], |x| {
                                    x.text("selection_number", &[], "1");
                                    x.element("selection_extension", &[], |x| {
                                        x.text("points_per_item", &[], &shortest(q.points));
                                    });
                                });
                            });
                            x.line();
                            of_problem.iter().filter_map(|f| f.questions.get(i)).for_each(|q| x.raw(q));
                        });
                        x.line();
                    }
                }
            });
        });
    });
    x.line();
    x.done()
}

/// What Canvas wants to know of the quiz besides.
fn meta(export: &Export, id: &str) -> String {
    let points: f64 = export.problems.iter().flat_map(|p| &p.questions).map(|q| q.points).sum();
    let mut x = Xml::file();
    let space = "http://canvas.instructure.com/xsd/cccv1p0";
    x.element("quiz", &[("xmlns", space), ("identifier", id)], |x| {
        x.text("title", &[], export.set);
        x.text("quiz_type", &[], "assignment");
        x.text("points_possible", &[], &shortest(points));
        x.text("allowed_attempts", &[], "1");
        x.text("scoring_policy", &[], "keep_highest");
        x.text("shuffle_answers", &[], "false");
    });
    x.line();
    x.done()
}

/// The archive. Errors: it would be too large.
pub fn file(export: &Export, fragments: Vec<Fragment>) -> Result<Vec<u8>, Finding> {
    let id = format!("quiz-{}", export.id);
    let (main, of_quiz) = (format!("{id}/{id}.xml"), format!("{id}/assessment_meta.xml"));
    let mut files = vec![
        (main.clone(), quiz(export, &fragments, &id).into_bytes()),
        (of_quiz.clone(), meta(export, &id).into_bytes()),
    ];
    let needed = format!("{id}-meta");
    let resource = |id: &str, kind: &str, file: String, needs: Vec<String>, named| Resource {
        id: id.to_owned(),
        kind: kind.to_owned(),
        files: vec![file],
        needs,
        named,
    };
    let mut resources = vec![
        resource(&id, "imsqti_xmlv1p2", main, vec![needed.clone()], false),
        resource(
            &needed,
            "associatedcontent/imscc_xmlv1p1/learning-application-resource",
            of_quiz,
            Vec::new(),
            true,
        ),
    ];
    for (path, bytes) in fragments.into_iter().flat_map(|f| f.files) {
        let id = format!("image-{}", resources.len());
        resources.push(resource(&id, "webcontent", path.clone(), Vec::new(), true));
        files.push((path, bytes));
    }
    let manifest = Manifest {
        id: &export.id,
        namespace: "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1",
        schema: ("IMS Content", "1.1.3"),
        resources: &resources,
    };
    manifest.archive(files)
}
