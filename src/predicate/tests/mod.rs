mod brute;
mod meeting;
mod oracle;
mod orient;
mod table;
