#include "core/signature/signature.h"

#include <openssl/bio.h>
#include <openssl/cms.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/file_bytes.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

struct Release {
  void operator()(BIO* bio) const { BIO_free_all(bio); }
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
  void operator()(X509* certificate) const { X509_free(certificate); }
  void operator()(CMS_ContentInfo* message) const { CMS_ContentInfo_free(message); }
  void operator()(STACK_OF(X509) * chain) const { sk_X509_pop_free(chain, X509_free); }
};

template <typename Kind>
using Owned = std::unique_ptr<Kind, Release>;

/// The problem, preceded by the name of the file.
Problem of(const std::string& path, const std::string& trouble) {
  return Problem{Phrase::of("%1: %2", visibleText(path), trouble)};
}

/// The reason of OpenSSL's last error, for experts.
std::string reasonOfOpenSsl() {
  const char* reason = ERR_reason_error_string(ERR_peek_last_error());
  ERR_clear_error();
  return reason ? reason : "unknown";
}

constexpr std::size_t mostBytesOfKey = std::size_t{1} << 20U;

Result<std::string> pemOf(const std::string& path) {
  Result<std::string> bytes = readFile(path);
  if (!bytes) return of(path, bytes.problem().text());
  if (bytes->size() > mostBytesOfKey)
    return of(path, Phrase::of("is far too long for a key or certificate: choose a PEM file"));
  return bytes;
}

Owned<BIO> memoryOf(std::string_view bytes) {
  return Owned<BIO>(BIO_new_mem_buf(bytes.data(), static_cast<int>(bytes.size())));
}

Result<std::string> passphraseOf(const SigningFiles& files) {
  if (files.passphraseFile.empty()) {
    const char* stated = std::getenv(passphraseVariable);
    return std::string(stated ? stated : "");
  }
  const Result<std::string> bytes = readFile(files.passphraseFile);
  if (!bytes) return of(files.passphraseFile, bytes.problem().text());
  return bytes->substr(0, bytes->find_first_of("\r\n"));
}

int handPassphrase(char* buffer, int size, int, void* given) {
  const std::string& passphrase = *static_cast<const std::string*>(given);
  if (passphrase.empty() || passphrase.size() > static_cast<std::size_t>(size)) return -1;
  return static_cast<int>(passphrase.copy(buffer, passphrase.size()));
}

/// May others access the file of the key? A key that others can read does not prove an identity. As with ssh,
/// only a file that the user owns is checked: its owner can change the permissions.
bool isOpenToOthers(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid() &&
         (status.st_mode & (S_IRWXG | S_IRWXO)) != 0;
}

Result<Owned<EVP_PKEY>> keyOf(const SigningFiles& files) {
  const Result<std::string> pem = pemOf(files.key);
  if (!pem) return pem.problem();
  if (pem->find("PRIVATE KEY") != std::string::npos && isOpenToOthers(files.key))
    return of(files.key,
              Phrase::of("is accessible to other users: allow only its owner to read the key (chmod 600)"));
  Result<std::string> passphrase = passphraseOf(files);
  if (!passphrase) return passphrase.problem();
  std::string opener = *std::move(passphrase);
  Owned<EVP_PKEY> key(PEM_read_bio_PrivateKey(memoryOf(*pem).get(), nullptr, handPassphrase, &opener));
  ERR_clear_error();
  if (key) return Result<Owned<EVP_PKEY>>(std::move(key));
  const bool isLocked = pem->find("ENCRYPTED") != std::string::npos;
  if (isLocked && opener.empty())
    return of(files.key, Phrase::of("is protected by a passphrase: state the passphrase in the environment "
                                    "variable %1 or in a file (--sign-passphrase-file)",
                                    passphraseVariable));
  if (isLocked)
    return of(files.key, Phrase::of("cannot be opened with this passphrase: check the passphrase"));
  return of(files.key, Phrase::of("holds no private key that can be read: choose a PEM file with one"));
}

struct Certificates {
  Owned<X509> own;
  Owned<STACK_OF(X509)> others;
};

Result<Certificates> certificatesOf(const std::string& path) {
  const Result<std::string> pem = pemOf(path);
  if (!pem) return pem.problem();
  const Owned<BIO> memory = memoryOf(*pem);
  Certificates read{Owned<X509>(PEM_read_bio_X509(memory.get(), nullptr, nullptr, nullptr)),
                    Owned<STACK_OF(X509)>(sk_X509_new_null())};
  while (X509* other = PEM_read_bio_X509(memory.get(), nullptr, nullptr, nullptr))
    sk_X509_push(read.others.get(), other);
  ERR_clear_error();
  if (!read.own)
    return of(path, Phrase::of("holds no certificate that can be read: choose a PEM file with one"));
  return Result<Certificates>(std::move(read));
}

/// "Mar  1 12:00:00 2026 GMT".
std::string dateText(const ASN1_TIME* time) {
  const Owned<BIO> memory(BIO_new(BIO_s_mem()));
  ASN1_TIME_print(memory.get(), time);
  char* text = nullptr;
  const long length = BIO_get_mem_data(memory.get(), &text);
  return {text, static_cast<std::size_t>(std::max(length, 0L))};
}

std::optional<Problem> whyUnfit(const SigningFiles& files, const EVP_PKEY& key, const X509& certificate) {
  const int matches = X509_check_private_key(&certificate, &key);
  ERR_clear_error();
  if (matches != 1)
    return of(files.certificate,
              Phrase::of("is not the certificate of the key %1: choose the two that belong together",
                         visibleText(files.key)));
  const ASN1_TIME *begin = X509_get0_notBefore(&certificate), *end = X509_get0_notAfter(&certificate);
  if (X509_cmp_current_time(end) <= 0)
    return of(files.certificate,
              Phrase::of("has expired (%1): sign with a valid certificate", dateText(end)));
  if (X509_cmp_current_time(begin) > 0)
    return of(files.certificate,
              Phrase::of("is not valid before %1: check the clock, or sign with another certificate",
                         dateText(begin)));
  return std::nullopt;
}

}  // namespace

struct Signer::Identity {
  Owned<EVP_PKEY> key;
  Certificates certificates;
  std::vector<std::string> paths;
};

Signer::Signer(std::shared_ptr<const Identity> identity) : m_identity(std::move(identity)) {}

Result<Signer> Signer::load(const SigningFiles& files) {
  Result<Owned<EVP_PKEY>> key = keyOf(files);
  if (!key) return key.problem();
  Result<Certificates> certificates = certificatesOf(files.certificate);
  if (!certificates) return certificates.problem();
  if (auto problem = whyUnfit(files, **key, *certificates->own)) return *std::move(problem);
  auto identity = std::make_shared<Identity>();
  identity->key = *std::move(key);
  identity->certificates = *std::move(certificates);
  identity->paths = {files.key, files.certificate};
  if (!files.passphraseFile.empty()) identity->paths.push_back(files.passphraseFile);
  return Signer(std::move(identity));
}

const std::vector<std::string>& Signer::paths() const {
  return m_identity->paths;
}

Result<std::string> Signer::sign(std::string_view bytes) const {
  const auto problem = [] {
    return Problem{Phrase::of("the signature cannot be made: %1", reasonOfOpenSsl())};
  };
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    return Problem{Phrase::of("the file is too long to be signed")};
  const Owned<CMS_ContentInfo> message(CMS_sign(m_identity->certificates.own.get(), m_identity->key.get(),
                                                m_identity->certificates.others.get(), memoryOf(bytes).get(),
                                                CMS_DETACHED | CMS_BINARY));
  if (!message) return problem();
  unsigned char* der = nullptr;
  const int length = i2d_CMS_ContentInfo(message.get(), &der);
  if (length <= 0) return problem();
  std::string signature(reinterpret_cast<const char*>(der), static_cast<std::size_t>(length));
  OPENSSL_free(der);
  return signature;
}

std::string signaturePath(const std::string& path) {
  return path + ".p7s";
}

}  // namespace alidade
