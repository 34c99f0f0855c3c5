#pragma once

#include <string>

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli self-test` was asked.
struct SelfTestRequest {
  std::string fits, numbers;  ///< paths of other references; empty: those compiled in
  bool json = false;
};

/// Adds `self-test [--fits FILE] [--numbers FILE] [--json]`, which fills in `request`.
void addSelfTestCommand(CLI::App& app, SelfTestRequest& request);

/// Prints the self-test. `Done` where everything passed, `Failed` where anything did not, `BadInput` where a
/// reference cannot be read.
int giveSelfTest(const SelfTestRequest& request);

}  // namespace alidade::console
