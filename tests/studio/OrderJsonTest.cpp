// SPDX-License-Identifier: Apache-2.0
// Orders as the page writes them.
#include <gtest/gtest.h>

#include "tools/studio/OrderJson.h"

namespace kelpie::studio {
namespace {

std::string wordsOf(const std::string& text) {
  const auto order = orderFromJson(text);
  return order ? sim::wordsFor(*order) : "refused";
}

TEST(OrderJson, EveryOrderHasItsForm) {
  EXPECT_EQ(wordsOf(R"({"do": "pause"})"), "pause");
  EXPECT_EQ(wordsOf(R"({"do": "resume"})"), "resume");
  EXPECT_EQ(wordsOf(R"({"do": "step", "frames": 3})"), "step 3");
  EXPECT_EQ(wordsOf(R"({"do": "speed", "factor": 0.5})"), "speed 0.5");
  EXPECT_EQ(wordsOf(R"({"do": "ball", "x": 12.25, "y": 300})"), "ball 12.25,300");
  EXPECT_EQ(wordsOf(R"({"do": "robot", "team": "blue", "player": 4, "x": 20, "y": 30.5,
                        "heading_deg": -45})"),
            "carry blue:4:20,30.5,-45");
}

TEST(OrderJson, NumbersOfAnyFormAreTakenAndOtherWordsPassedOver) {
  EXPECT_EQ(wordsOf(R"({"do": "ball", "x": 1e2, "y": -0.0, "z": 7})"), "ball 100,-0");
  EXPECT_EQ(wordsOf(R"({"do": "ball", "x": 0.1, "y": 179.99999999999997})"),
            "ball 0.1,179.99999999999997");
  EXPECT_EQ(wordsOf(R"({"do": "pause", "frames": []})"), "pause");
}

TEST(OrderJson, NonsenseIsRefused) {
  const std::string deep(100000, '[');
  for (const std::string& text :
       {std::string(),
        std::string("{"),
        std::string("null"),
        std::string("[]"),
        std::string("7"),
        std::string("{}"),
        std::string(R"({"do": 7})"),
        std::string(R"({"do": null})"),
        std::string(R"({"do": "halt"})"),
        std::string(R"({"do": "pause\nresume"})"),

        std::string(R"({"do": "step"})"),
        std::string(R"({"do": "step", "frames": 0})"),
        std::string(R"({"do": "step", "frames": 1.5})"),
        std::string(R"({"do": "step", "frames": true})"),
        std::string(R"({"do": "speed", "factor": 1e999})"),
        std::string(R"({"do": "speed", "factor": "nan"})"),
        std::string(R"({"do": "ball", "x": 1})"),
        std::string(R"({"do": "ball", "x": [], "y": 1})"),
        std::string(R"({"do": "ball", "x": null, "y": 1})"),
        std::string(R"({"do": "ball", "x": "1\n2", "y": 1})"),
        std::string(R"({"do": "ball", "x": 1e300, "y": 1})"),
        std::string(R"({"do": "robot", "team": "green", "player": 1, "x": 1, "y": 1,
                        "heading_deg": 0})"),
        std::string(R"({"do": "robot", "team": "red", "player": 1, "x": 1, "y": 1})"),
        std::string("\xFF\xFE"),
        deep,
        "{\"do\":" + deep})
    EXPECT_EQ(wordsOf(text), "refused") << text.substr(0, 100);
}

// Whatever a text holds, the match hears the words that we make of the order.
TEST(OrderJson, ATextInPlaceOfANumberBringsNoSecondOrder) {
  const std::string words = wordsOf(R"({"do": "ball", "x": "1", "y": "2,3,4\nball 9,9"})");
  EXPECT_EQ(words.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace kelpie::studio
