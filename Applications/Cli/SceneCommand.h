#pragma once

#include "Command.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// `palpate scene explain SCENE`: makes what a scene to touch needs, as `touch --view` does, and
/// says what was made for what, at what price, and what was not and why.
class SceneCommand : public Command
{
public:
  std::string Name() const override { return "scene"; }
  std::string Summary() const override
  {
    return "Say what a scene to touch is made of, and what is left out and why";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::string Action;
  std::filesystem::path Input;
  bool IsUnseen = false;
  bool Json = false;
};
} // namespace palpate::cli
