#include "StudyWriting.h"

#include <future>
#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>

namespace palpate::study_writing_test
{
namespace
{
class StudyWritingTest : public testing::Test
{
protected:
  void Settle()
  {
    while (this->Jobs.WaitForResult())
    {
      this->Jobs.Deliver();
    }
  }
  StudyJobs Jobs;
  StudyWriting Writing{Jobs};
  std::string Message;
  std::function<void(const std::string&)> Fail = [this](const std::string& text)
  { this->Message = text; };
};

TEST_F(StudyWritingTest, WritesOnAnotherThread)
{
  std::thread::id writer;
  this->Writing.Start(
      "a.stl", [&writer](const ProgressFunction&) { writer = std::this_thread::get_id(); },
      this->Fail);
  ASSERT_EQ(this->Writing.Waiting().size(), 1U);
  EXPECT_EQ(this->Writing.Waiting()[0].Path, "a.stl");
  this->Settle();
  EXPECT_NE(writer, std::thread::id());
  EXPECT_NE(writer, std::this_thread::get_id());
  EXPECT_TRUE(this->Writing.Waiting().empty());
  EXPECT_EQ(this->Message, "");
}

TEST_F(StudyWritingTest, ReportsAFailure)
{
  this->Writing.Start(
      "a.stl", [](const ProgressFunction&) { throw std::runtime_error("full"); }, this->Fail);
  this->Settle();
  EXPECT_EQ(this->Message, "full");
  EXPECT_TRUE(this->Writing.Waiting().empty());
}

TEST_F(StudyWritingTest, CancelStopsAtTheNextProgress)
{
  std::promise<void> started;
  std::promise<bool> goesOn;
  this->Writing.Start(
      "a.stl",
      [&](const ProgressFunction& progress)
      {
        started.set_value();
        while (progress(0.5, "writing"))
        {
          std::this_thread::yield();
        }
        goesOn.set_value(false);
      },
      this->Fail);
  started.get_future().wait();
  this->Writing.Cancel();
  EXPECT_TRUE(this->Writing.Waiting().empty());
  EXPECT_FALSE(goesOn.get_future().get());
  this->Settle();
  EXPECT_EQ(this->Message, "");
}
} // namespace
} // namespace palpate::study_writing_test
