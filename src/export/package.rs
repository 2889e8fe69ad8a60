//! A ZIP archive that a platform takes: files and a manifest that lists them. No file has a time, so that the same set gives the
//! same bytes.
use crate::export::Export;
use crate::finding::Finding;
use serde_json::{Value, json};
use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The archive: the manifest, then the files in this order. The manifest has its namespace and schema, with its version, and lists
/// resources: each its files, the main one first, which may be `named` on the resource itself, and the ids of those that it `needs`.
/// Errors: it would be larger than an archive can be.
pub fn archive(
    export: &Export,
    (namespace, schema): (&str, [&str; 2]),
    resources: &[Value],
    files: Vec<(String, Vec<u8>)>,
) -> Result<Vec<u8>, Finding> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644);
    let manifest = json!({"id": export.id, "namespace": namespace, "schema": schema, "resources": resources});
    let manifest = ("imsmanifest.xml".to_owned(), export.made("manifest.xml", &manifest)?.into_bytes());
    let fault = |e: zip::result::ZipError| Finding::new("", format!("the archive cannot be made: {e}"));
    for (name, bytes) in std::iter::once(manifest).chain(files) {
        zip.start_file(name, options).map_err(fault)?;
        zip.write_all(&bytes).map_err(|e| fault(e.into()))?;
    }
    Ok(zip.finish().map_err(fault)?.into_inner())
}
