// Works in memory until it is stopped: what another program on the machine does to one that is measured.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

int main(int argc, char** argv) {
  const long megabytes = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 256;
  if (argc > 2 || megabytes < 1) {
    std::fprintf(stderr,
                 "usage: neighbour [MEGABYTES]\nreads and writes so much memory here and there [256]\n");
    return 2;
  }
  std::vector<std::uint64_t> words(static_cast<std::size_t>(megabytes) * (std::size_t{1} << 17U), 1);
  // Marsaglia's xorshift: every access is somewhere else, and none waits for another one.
  std::uint64_t at = 88172645463325252U;
  for (volatile bool goesOn = true; goesOn;) {
    at ^= at << 13U;
    at ^= at >> 7U;
    at ^= at << 17U;
    words[at % words.size()] += at;
  }
  return 0;
}
