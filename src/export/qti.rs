//! QTI 2.1 and 3.0, which differ in names alone: an item for each variant, and a test that draws one of each problem.
//!
//! A number counts within a range, written as two comparisons: a tolerance of QTI (`equal` with `toleranceMode`) is scored as 0 by
//! players that do not know it. Each part has a score of its own; `SCORE` is their sum.
use crate::export::item::Item;
use crate::export::{Export, Fragment, package, part_view};
use crate::finding::Finding;
use crate::set::key_file::shortest;
use serde_json::{Value, json};

/// What differs between the versions.
pub struct Dialect {
    /// Begins the names of its templates.
    name: &'static str,
    /// Attributes of items and tests: namespaces, and the address of the schema.
    spaces: &'static str,
    /// Namespace of the manifest, its schema and version.
    manifest: (&'static str, [&'static str; 2]),
    /// What a manifest calls an item.
    item_kind: &'static str,
    /// What a manifest calls a test.
    test_kind: &'static str,
    /// Does the text of a feedback stand in a body of its own?
    content_body: bool,
}

/// QTI 2.1, in whose names the templates are written.
pub const QTI21: Dialect = Dialect {
    name: "qti21",
    spaces: "xmlns=\"http://www.imsglobal.org/xsd/imsqti_v2p1\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imsqti_v2p1 http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1p2.xsd\"",
    manifest: ("http://www.imsglobal.org/xsd/imscp_v1p1", ["QTIv2.1 Package", "1.0.0"]),
    item_kind: "imsqti_item_xmlv2p1",
    test_kind: "imsqti_test_xmlv2p1",
    content_body: false,
};

/// QTI 3.0.
pub const QTI3: Dialect = Dialect {
    name: "qti3",
    spaces: "xmlns=\"http://www.imsglobal.org/xsd/imsqtiasi_v3p0\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imsqtiasi_v3p0 https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd/imsqti_asiv3p0_v1p0.xsd\"",
    manifest: ("http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1", ["QTI Package", "3.0.0"]),
    item_kind: "imsqti_item_xmlv3p0",
    test_kind: "imsqti_test_xmlv3p0",
    content_body: true,
};

/// A template of QTI 2.1 in the names of 3.0: elements are those of 2.1 in small letters behind `qti-`, attributes likewise
/// (`responseIdentifier` is `response-identifier`).
pub fn in_version_3(template: &str) -> String {
    let (mut in_tag, mut in_quotes) = (false, false);
    let mut out = String::with_capacity(template.len() * 2);
    for c in template.chars() {
        match c {
            '<' | '>' if !in_quotes => in_tag = c == '<',
            '"' if in_tag => in_quotes = !in_quotes,
            c if in_tag && !in_quotes && c.is_ascii_uppercase() => out.push('-'),
            _ => {}
        }
        out.push(if in_tag && !in_quotes { c.to_ascii_lowercase() } else { c });
    }
    out.replace('<', "<qti-").replace("<qti-/", "</qti-").replace("<qti-?", "<?")
}

fn address(file: &str) -> String {
    format!("../{}", path(file))
}

fn path(file: &str) -> String {
    format!("figures/{file}")
}

/// XHTML whose formulas say that they are MathML, as XML wants it and HTML does not.
fn with_mathml(xhtml: &str) -> String {
    xhtml.replace("<math ", "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" ")
}

/// The item of a variant. Errors: faults of the templates.
pub fn fragment(dialect: &Dialect, export: &Export, item: &Item) -> Result<Fragment, Finding> {
    let made = |of: &str| format!("{}-{of}.xml", dialect.name);
    let id = format!("p{}-{}", item.problem + 1, item.code);
    let parts: Vec<Value> = item.parts.iter().map(|part| part_view(part, item.words)).collect();
    // The places for the answers to the parts.
    let places = parts.iter().map(|part| export.made(&made("interaction"), part));
    let places: Vec<String> = places.collect::<Result<_, _>>()?;
    let view = json!({
        "spaces": dialect.spaces,
        "content_body": dialect.content_body,
        "id": id,
        "title": format!("{} {}", item.title, item.code),
        "language": export.language,
        "points": shortest(item.points()),
        "parts": parts,
        "text": with_mathml(&item.text(None, &mut |i| places[i].clone(), &address)),
        "solution": item.solution(&address).map(|solution| with_mathml(&solution)),
    });
    let mut files = vec![(format!("items/{id}.xml"), export.made(&made("item"), &view)?.into_bytes())];
    files.extend(item.pictures.iter().map(|p| (path(&p.file), p.svg.clone().into_bytes())));
    Ok(Fragment { problem: item.problem, code: item.code.to_owned(), questions: vec![id], files })
}

/// The archive: the items and a test, which draws one variant of each problem. Errors: it would be too large.
pub fn file(dialect: &Dialect, export: &Export, fragments: Vec<Fragment>) -> Result<Vec<u8>, Finding> {
    const TEST: &str = "test.xml";
    let whole = export.whole("test", dialect.spaces, &fragments);
    let text = export.made(&format!("{}-test.xml", dialect.name), &whole)?.into_bytes();
    let ids = || fragments.iter().flat_map(|f| &f.questions);
    let needs: Vec<&String> = ids().collect();
    let test =
        json!({"id": "test", "kind": dialect.test_kind, "files": [TEST], "needs": needs, "named": true});
    let items = fragments.iter().zip(ids()).map(|(fragment, id)| {
        let files: Vec<&String> = fragment.files.iter().map(|(path, _)| path).collect();
        json!({"id": id, "kind": dialect.item_kind, "files": files, "needs": [], "named": true})
    });
    let resources: Vec<Value> = std::iter::once(test).chain(items).collect();
    let mut files = vec![(TEST.to_owned(), text)];
    files.extend(fragments.into_iter().flat_map(|f| f.files));
    package::archive(export, dialect.manifest, &resources, files)
}
