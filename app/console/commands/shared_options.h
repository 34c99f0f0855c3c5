#pragma once

#include <optional>

#include "app/console/batch.h"
#include "core/base/result.h"
#include "core/signature/signature.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// Adds `[--threads N] [--progress] [--json] [--json-lines]` to a subcommand for many files.
void addBatchOptions(CLI::App& command, BatchOptions& options);

/// Adds `[--sign-key KEY --sign-certificate CERT [--sign-passphrase-file FILE]]` to a subcommand that writes
/// a file.
void addSigningOptions(CLI::App& command, SigningFiles& files);

/// Absent if no signature is requested.
Result<std::optional<Signer>> signerOf(const SigningFiles& files);

}  // namespace alidade::console
