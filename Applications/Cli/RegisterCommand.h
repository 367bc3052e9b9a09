#pragma once

#include "Command.h"
#include "FileRegistration.h"
#include "ImageOptions.h"
#include "TransformFile.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// `palpate register MOVING FIXED`: the map that brings a body or points onto another one.
class RegisterCommand : public Command
{
public:
  std::string Name() const override { return "register"; }
  std::string Summary() const override
  {
    return "Bring two bodies or images together by surfaces, touched points, landmarks or values";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  FileRegistrationSettings ReadSettings() const;
  TransformImages TransformFrames() const;

  std::filesystem::path Moving;
  std::filesystem::path Fixed;
  std::filesystem::path MovingLandmarks;
  std::filesystem::path FixedLandmarks;
  ImageOptions Images;
  FileRegistrationSettings Settings;
  std::string Kind = "rigid";
  std::string Start; ///< empty: by the kind of the sides
  std::filesystem::path Initial;
  std::filesystem::path Output;
  bool Json = false;
};
} // namespace palpate::cli
