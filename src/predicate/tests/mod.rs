pub(crate) mod brute;
mod meeting;
pub(crate) mod oracle;
mod orient;
mod ray;
mod sphere;
mod table;
mod word;
