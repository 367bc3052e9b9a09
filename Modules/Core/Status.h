#pragma once

#include <string>
#include <utility>

namespace palpate
{
/// What a kernel that can refuse its input answers: success, or one sentence that says why not.
/// Level 0 throws nothing; callers turn the sentence into their own kind of error.
class [[nodiscard]] Status
{
public:
  static Status Success() { return {}; }
  static Status Failure(std::string message) { return Status(std::move(message)); }

  bool IsOk() const noexcept { return this->Ok; }
  const std::string& Message() const noexcept { return this->Text; }

private:
  Status() = default;
  explicit Status(std::string message) : Ok(false), Text(std::move(message)) {}

  bool Ok = true;
  std::string Text;
};
} // namespace palpate
