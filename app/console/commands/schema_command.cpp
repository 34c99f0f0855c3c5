#include "app/console/commands/schema_command.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "core/answers/schemas.h"
#include "core/base/list_text.h"
#include "core/base/visible_text.h"

namespace alidade::console {

namespace {

std::string namesOfSchemas() {
  std::vector<std::string> names;
  for (const AnswerSchema& schema : answerSchemas()) names.emplace_back(schema.name);
  return listed(names, " or ");
}

}  // namespace

void addSchemaCommand(CLI::App& app, std::string& name) {
  CLI::App* schema = app.add_subcommand(
      "schema", "The JSON Schema of an answer, or of the session file, for programs that read them.");
  schema->add_option("NAME", name, "Of what: " + namesOfSchemas())->required();
}

Result<std::string> runSchema(const std::string& name) {
  for (const AnswerSchema& schema : answerSchemas())
    if (schema.name == name) return std::string(schema.text);
  return Problem{"there is no schema " + quotation(name) + ": ask for " + namesOfSchemas()};
}

}  // namespace alidade::console
