#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace alidade {

/// Where a key and its certificate lie, PEM each, and what opens the key.
struct SigningFiles {
  std::string key;          ///< path of a private key
  std::string certificate;  ///< path: the signer's certificate first, those that vouch for it behind
  std::string
      passphraseFile;  ///< its first line opens the key; empty: the environment's `passphraseVariable`
};

/// Passphrases stand on no command line, where everybody on the machine could read them.
inline constexpr const char* passphraseVariable = "ALIDADE_SIGN_PASSPHRASE";

/// Signs bytes in the name of a certificate: detached, after the Cryptographic Message Syntax (RFC 5652), by
/// OpenSSL, DER. `openssl cms -verify -binary -inform DER -in FILE.p7s -content FILE` checks it.
class Signer {
 public:
  /// Fails where the key is open to others, where a file cannot be read or is none of its kind, the
  /// passphrase does not open the key, the key is not that of the certificate, or the certificate is not
  /// valid now.
  static Result<Signer> load(const SigningFiles& files);

  Result<std::string> sign(std::string_view bytes) const;
  /// The files that it was loaded from, which nothing that it signs may replace.
  const std::vector<std::string>& paths() const;

 private:
  struct Identity;
  explicit Signer(std::shared_ptr<const Identity> identity);

  std::shared_ptr<const Identity> m_identity;
};

/// Beside the file that it signs: "report.pdf.p7s".
std::string signaturePath(const std::string& path);

}  // namespace alidade
