#include <gnu/libc-version.h>
#include <openssl/crypto.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <cfloat>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "core/base/file_bytes.h"
#include "core/base/number_text.h"
#include "core/self_test/self_test.h"

namespace alidade {

namespace {

/// The value after `mark` in the first line of a system file that begins with `key`; empty without one.
std::string valueIn(const char* path, const std::string& key, char mark) {
  const Result<std::string> text = readFile(path);
  if (!text) return {};
  for (std::size_t at = 0; at < text->size();) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    if (text->compare(at, key.size(), key) == 0) {
      const std::size_t begin = text->find(mark, at);
      if (begin < end) {
        std::string value = text->substr(begin + 1, end - begin - 1);
        std::erase(value, '"');
        value.erase(0, value.find_first_not_of(" \t"));
        return value;
      }
    }
    at = end + 1;
  }
  return {};
}

std::string joined(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string compilerName() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "";
#endif
}

}  // namespace

EnvironmentFacts coreEnvironment() {
  EnvironmentFacts facts{
      {"compiler", compilerName()},
      {"numbers", "double with " + std::to_string(DBL_MANT_DIG) + " bits, FLT_EVAL_METHOD " +
                      std::to_string(FLT_EVAL_METHOD) +
                      (std::numeric_limits<double>::is_iec559 ? ", IEEE 754" : "")},
      {"C library", std::string("glibc ") + gnu_get_libc_version()},
      {"Eigen", joined(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"Boost", joined(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"nlohmann-json",
       joined(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"OpenSSL", OpenSSL_version(OPENSSL_VERSION)},
      {"system", valueIn("/etc/os-release", "PRETTY_NAME", '=')},
      {"processor", valueIn("/proc/cpuinfo", "model name", ':') + ", " +
                        std::to_string(std::thread::hardware_concurrency()) + " threads"}};
  utsname kernel{};
  if (uname(&kernel) == 0)
    facts.emplace_back("kernel", std::string(kernel.sysname) + " " + kernel.release + " " + kernel.machine);
  return facts;
}

}  // namespace alidade
