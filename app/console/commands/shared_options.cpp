#include "app/console/commands/shared_options.h"

#include <CLI/CLI.hpp>
#include <string>
#include <utility>

#include "app/console/commands/option_checks.h"

namespace alidade::console {

void addBatchOptions(CLI::App& command, BatchOptions& options) {
  constexpr unsigned mostThreads = 1024;
  command
      .add_option("--threads", options.threads,
                  "Threads for many files; 0: all. The result does not depend on it")
      ->check(wholeFrom(0, mostThreads))
      ->capture_default_str();
  command.add_flag("--progress", options.progress,
                   "Report on stderr how many files are done, even if stderr is no terminal");
  command.add_flag("--json", options.json, "Print one JSON document; of many files, one line for each");
  command.add_flag_callback(
      "--json-lines", [&options] { options.json = options.jsonLines = true; },
      "As --json, but one line for each file even if there is only one");
}

void addSigningOptions(CLI::App& command, SigningFiles& files) {
  CLI::Option* key = command.add_option(
      "--sign-key", files.key, "Private key (PEM) to sign with, in a file *.p7s next to the signed file");
  CLI::Option* certificate =
      command.add_option("--sign-certificate", files.certificate, "Its certificate (PEM)");
  key->needs(certificate);
  certificate->needs(key);
  command
      .add_option(
          "--sign-passphrase-file", files.passphraseFile,
          std::string("File whose first line opens the key; else the environment's ") + passphraseVariable)
      ->needs(key);
}

Result<std::optional<Signer>> signerOf(const SigningFiles& files) {
  if (files.key.empty()) return std::optional<Signer>();
  Result<Signer> signer = Signer::load(files);
  if (!signer) return signer.problem();
  return std::optional<Signer>(*std::move(signer));
}

}  // namespace alidade::console
