#pragma once

#include "Command.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// `palpate scene explain SCENE`: builds a scene as `touch` does, and reports what was built, at
/// what cost, and what was not and why.
class SceneCommand : public Command
{
public:
  std::string Name() const override { return "scene"; }
  std::string Summary() const override
  {
    return "Explain what a scene to touch is built from, and what is left out and why";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::string Action;
  std::filesystem::path Input;
  bool Json = false;
};
} // namespace palpate::cli
