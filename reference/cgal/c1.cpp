// Claim C1 `positivity` with CGAL: the signs of the 24 tets of every prism.
//
//   c1 [--epeck] [--serve] BOTTOM.off MIDDLE.off TOP.off
//
// Prints one line of key=value: prisms, tets (those on a pinched pillar left out), not_positive, and the seconds of the
// evaluation; with --serve one for every line `run` of standard input. Reading and building CGAL points are not timed.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "positivity.hpp"
#include "serve.hpp"

template <class Kernel>
void run(const Shell& shell, bool stay) {
  const PointShell<Kernel> points(shell);
  const auto once = [&] {
    Watch watch;
    const Counts counts = points.positivity();
    const double seconds = watch.lap();
    std::cout << std::setprecision(9) << "prisms=" << shell.faces.size() << " tets=" << counts.tets
              << " not_positive=" << counts.bad << " seconds=" << seconds << '\n';
  };
  stay ? serve(once) : once();
}

int main(int argc, char** argv) {
  bool epeck = false, stay = false;
  int at = 1;
  for (; at < argc && argv[at][0] == '-'; ++at) {
    const std::string option = argv[at];
    if (option == "--epeck") {
      epeck = true;
    } else if (option == "--serve") {
      stay = true;
    } else {
      refuse("unknown option " + option);
    }
  }
  if (argc - at != 3) refuse("usage: c1 [--epeck] [--serve] BOTTOM.off MIDDLE.off TOP.off");
  const Shell shell = read_shell(argv + at);
  if (epeck) {
    run<CGAL::Exact_predicates_exact_constructions_kernel>(shell, stay);
  } else {
    run<CGAL::Exact_predicates_inexact_constructions_kernel>(shell, stay);
  }
}
