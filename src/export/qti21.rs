//! QTI 2.1: the names of its elements, files and namespaces.
use crate::export::qti::Dialect;
use std::borrow::Cow;

/// QTI 2.1, in whose names [`crate::export::qti`] is written.
pub const DIALECT: Dialect = Dialect {
    namespace: "http://www.imsglobal.org/xsd/imsqti_v2p1",
    schema_location: "http://www.imsglobal.org/xsd/imsqti_v2p1 http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1p2.xsd",
    manifest_namespace: "http://www.imsglobal.org/xsd/imscp_v1p1",
    schema: ("QTIv2.1 Package", "1.0.0"),
    item_kind: "imsqti_item_xmlv2p1",
    test_kind: "imsqti_test_xmlv2p1",
    element: |name| Cow::Borrowed(name),
    attribute: |name| Cow::Borrowed(name),
    content_body: false,
};
