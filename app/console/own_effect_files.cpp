#include "app/console/own_effect_files.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "app/console/channels.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/own_effect_check.h"

namespace alidade::console {

namespace {

namespace fs = std::filesystem;

/// The file at `path`, or the effect files in the folder at `path`, sorted by name.
Result<std::vector<std::string>> filesOf(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return std::vector{path};
  std::vector<std::string> files;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
    if (const fs::path& file = entry->path();
        file.extension() == ".alidade-effect" && !file.filename().string().starts_with('.'))
      files.push_back(file.string());
  if (error) return Problem{"the folder cannot be read: " + error.message()};
  if (files.empty()) return Problem{"the folder has no file *.alidade-effect"};
  std::ranges::sort(files);
  return files;
}

}  // namespace

void addEffectsOption(CLI::App& command, std::vector<std::string>& paths) {
  command
      .add_option("--effects", paths,
                  "Take up effects of your own (*.alidade-effect, or a folder of them) where they have no "
                  "owner, or this device or instrument; may be given several times")
      ->take_all()
      ->expected(1);
}

Result<std::vector<OwnEffect>> ownEffectsIn(const std::vector<std::string>& paths) {
  std::vector<OwnEffect> effects;
  for (const std::string& path : paths) {
    const Result<std::vector<std::string>> files = filesOf(path);
    if (!files) return Problem{"--effects " + visibleText(path) + ": " + files.problem().text()};
    for (const std::string& file : *files) {
      Result<OwnEffect> effect = loadOwnEffect(file);
      if (!effect) return Problem{"--effects " + visibleText(file) + ": " + effect.problem().text()};
      effects.push_back(*std::move(effect));
    }
  }
  return effects;
}

std::optional<Problem> addOwnEffects(Session& session, const std::vector<std::string>& paths) {
  const Result<std::vector<OwnEffect>> effects = ownEffectsIn(paths);
  if (!effects) return effects.problem();
  for (const OwnEffect& effect : *effects) takeOwnEffect(session, effect);
  return std::nullopt;
}

void reportOwnEffects(const std::string& name, const Measurement& measurement) {
  if (!measurement.own) return;
  for (const OwnEntry& entry : measurement.own->entries())
    if (const auto check = checkOwnEffect(measurement, entry.id))
      for (const std::string& sentence : check->sentences())
        notify(name, visibleText(entry.id) + ": " + sentence);
}

}  // namespace alidade::console
