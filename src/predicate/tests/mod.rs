mod oracle;
mod orient;
