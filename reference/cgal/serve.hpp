// Measured programs stay and work once for every line `run` of standard input, so that others can take turns.
#pragma once
#include <chrono>
#include <iomanip>

#include "off.hpp"

// Seconds since the beginning of this value, or since the last lap.
class Watch {
 public:
  double lap() {
    const auto now = Clock::now();
    const double out = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return out;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

// Says `ready`, then answers lines `run` by what `work` prints (one line) until the input ends.
template <class Work>
void serve(const Work& work) {
  std::cout << std::setprecision(9) << "ready" << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    if (line != "run") refuse("not `run`: " + line);
    work();
    std::cout.flush();
  }
}
