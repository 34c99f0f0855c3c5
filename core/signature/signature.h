#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace alidade {

/// Paths of a key and its certificate, both PEM files, and the source of the passphrase.
struct SigningFiles {
  std::string key;          ///< path of a private key
  std::string certificate;  ///< path: the signer's certificate first, followed by its chain
  std::string
      passphraseFile;  ///< its first line is the passphrase; empty: the environment's `passphraseVariable`
};

/// The environment variable with the passphrase. No option takes it, as all users can read command lines.
inline constexpr const char* passphraseVariable = "ALIDADE_SIGN_PASSPHRASE";

/// Makes detached signatures after the Cryptographic Message Syntax (RFC 5652), DER, with OpenSSL.
/// `openssl cms -verify -binary -inform DER -in FILE.p7s -content FILE` checks a signature.
class Signer {
 public:
  /// Fails if others may access the key's file, a file is unreadable or of the wrong kind, or the passphrase
  /// is wrong. Also fails if key and certificate do not match, or the certificate is not valid now.
  static Result<Signer> load(const SigningFiles& files);

  Result<std::string> sign(std::string_view bytes) const;
  /// The files from which the signer was loaded; signed output must not replace them.
  const std::vector<std::string>& paths() const;

 private:
  struct Identity;
  explicit Signer(std::shared_ptr<const Identity> identity);

  std::shared_ptr<const Identity> m_identity;
};

/// The path of the signature, next to the signed file: "report.pdf.p7s".
std::string signaturePath(const std::string& path);

}  // namespace alidade
