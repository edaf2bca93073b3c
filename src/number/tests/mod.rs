mod dyadic;
mod fixed;
mod rational;
