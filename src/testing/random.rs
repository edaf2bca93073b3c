pub(crate) use crate::fuzz::random::Random;
