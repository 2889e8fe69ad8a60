//! QTI 3.0: the names of its elements, files and namespaces.
use crate::export::qti::Dialect;
use std::borrow::Cow;

/// QTI 3.0: elements are those of 2.1 in small letters behind `qti-`, attributes likewise.
pub const DIALECT: Dialect = Dialect {
    namespace: "http://www.imsglobal.org/xsd/imsqtiasi_v3p0",
    schema_location: "http://www.imsglobal.org/xsd/imsqtiasi_v3p0 https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd/imsqti_asiv3p0_v1p0.xsd",
    manifest_namespace: "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1",
    schema: ("QTI Package", "3.0.0"),
    item_kind: "imsqti_item_xmlv3p0",
    test_kind: "imsqti_test_xmlv3p0",
    element: |name| Cow::Owned(format!("qti-{}", hyphens(name))),
    attribute: |name| Cow::Owned(hyphens(name)),
    content_body: true,
};

/// `responseIdentifier` as `response-identifier`; a name with a prefix stays as it is.
fn hyphens(name: &str) -> String {
    if name.contains(':') {
        return name.to_owned();
    }
    let mut out = String::new();
    for c in name.chars() {
        if c.is_ascii_uppercase() {
            out.push('-');
        }
        out.push(c.to_ascii_lowercase());
    }
    out
}
