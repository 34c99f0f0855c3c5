#pragma once

#include <string>

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli self-test`.
struct SelfTestRequest {
  std::string fits, numbers;  ///< paths of other references; empty: the built-in ones
  bool json = false;
};

/// Adds `self-test [--fits FILE] [--numbers FILE] [--json]`, which fills in `request`.
void addSelfTestCommand(CLI::App& app, SelfTestRequest& request);

/// Prints the self-test. Returns `Done` if everything passed, `Failed` if anything failed, and `BadInput` if
/// a reference cannot be read.
int giveSelfTest(const SelfTestRequest& request);

}  // namespace alidade::console
