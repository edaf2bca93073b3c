//! Prismatic shells (THEORY section 1).

/// A shell: one prism per triangle of `faces`, with bottom, middle and top points per vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shell {
    /// Bottom points `b_v`.
    pub bottom: Vec<[f64; 3]>,
    /// Middle points `m_v`.
    pub middle: Vec<[f64; 3]>,
    /// Top points `t_v`.
    pub top: Vec<[f64; 3]>,
    /// The middle complex: three vertex ids a prism, in orientation order.
    pub faces: Vec<[u32; 3]>,
}
