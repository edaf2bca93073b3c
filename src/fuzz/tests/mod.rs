mod campaign;
mod generate;
mod judge;
mod process;
mod shrink;
mod text;
