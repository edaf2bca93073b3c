// The sign of ((b-a) x (c-a)) . (t-s), a predicate that CGAL's kernels do not have.
#pragma once
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_predicate.h>

template <class Kernel>
struct Dot {
  using Point = typename Kernel::Point_3;
  using result_type = typename CGAL::Same_uncertainty_nt<CGAL::Sign, typename Kernel::FT>::type;
  result_type operator()(const Point& a, const Point& b, const Point& c, const Point& s, const Point& t) const {
    return CGAL::sign(CGAL::cross_product(b - a, c - a) * (t - s));
  }
};

// Constructions of EPECK are exact.
template <class Kernel>
struct DotOf {
  using type = Dot<Kernel>;
};

// Those of EPICK are not: intervals first, then exact numbers, as CGAL makes the predicates that it has.
template <>
struct DotOf<CGAL::Exact_predicates_inexact_constructions_kernel> {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using type = CGAL::Filtered_predicate<Dot<Kernel::Exact_kernel>, Dot<Kernel::Approximate_kernel>, Kernel::C2E,
                                        Kernel::C2F>;
};
