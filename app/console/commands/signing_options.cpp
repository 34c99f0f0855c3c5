#include "app/console/commands/signing_options.h"

#include <CLI/CLI.hpp>
#include <string>
#include <utility>

namespace alidade::console {

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
