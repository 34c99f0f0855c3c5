#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

#include "tests/bench/speed/readings.h"

// alidade_speed [GOOGLE BENCHMARK OPTION]... times the workloads, one file for each
// alidade_speed --readings FOLDER writes their readings, for peers in other languages: all a,
//                                              then all e, as doubles in rad

namespace {

using namespace alidade::bench;

bool write(const std::string& path, const ArcReadings& readings) {
  std::ofstream file(path, std::ios::binary);
  for (const auto& values : {readings.a, readings.e})
    file.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(double)));
  return static_cast<bool>(file.flush());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--readings") == 0) {
    const std::string folder = argv[2];
    if (write(folder + "/short-arcs", shortArcs()) && write(folder + "/long-arc", longArc())) return 0;
    std::fprintf(stderr, "%s: the readings cannot be written there\n", argv[2]);
    return 1;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
