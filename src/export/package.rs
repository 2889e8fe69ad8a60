//! A ZIP archive that a platform takes: files and a manifest that lists them. No file has a time, so that the same set gives the
//! same bytes.
use crate::export::Export;
use crate::finding::Finding;
use serde::Serialize;
use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// A resource of a manifest.
#[derive(Serialize)]
pub struct Resource {
    /// Its identifier.
    pub id: String,
    pub kind: &'static str,
    /// Its files, the main one first.
    pub files: Vec<String>,
    /// Identifiers of resources that it needs.
    pub needs: Vec<String>,
    /// Is the main file named on the resource itself?
    pub named: bool,
}

/// The manifest of an archive.
#[derive(Serialize)]
pub struct Manifest<'m> {
    /// Its identifier.
    pub id: &'m str,
    /// Namespace of its elements.
    pub namespace: &'m str,
    /// Schema and its version.
    pub schema: (&'m str, &'m str),
    /// What is listed.
    pub resources: Vec<Resource>,
}

impl Manifest<'_> {
    /// The archive: the manifest, then the files in this order. Errors: it would be larger than an archive can be.
    pub fn archive(&self, export: &Export, files: Vec<(String, Vec<u8>)>) -> Result<Vec<u8>, Finding> {
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(DateTime::default())
            .unix_permissions(0o644);
        let manifest = ("imsmanifest.xml".to_owned(), export.made("manifest.xml", self)?.into_bytes());
        let fault = |e: zip::result::ZipError| Finding::new("", format!("the archive cannot be made: {e}"));
        for (name, bytes) in std::iter::once(manifest).chain(files) {
            zip.start_file(name, options).map_err(fault)?;
            zip.write_all(&bytes).map_err(|e| fault(e.into()))?;
        }
        Ok(zip.finish().map_err(fault)?.into_inner())
    }
}
