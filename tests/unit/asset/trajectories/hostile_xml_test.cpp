// XML that is meant to do harm is refused with a sentence, in linear time.
#include "fixture.h"

#ifdef CLAQUE_HAS_EXPAT

namespace claque::testing
{
namespace
{

TEST(HostileTrajectories, EntitiesThatGrowAreRefused)
{
    std::string text = "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY a \"lol\">";
    for (char c = 'b'; c < 'k'; ++c) {
        text += std::string("<!ENTITY ") + c + " \"";
        for (int i = 0; i < 10; ++i) text += std::string("&") + static_cast<char>(c - 1) + ";";
        text += "\">";
    }
    const Refusal refusal = refusal_of(bytes_of_text(text + "]>\n<fcd-export>&j;</fcd-export>"));
    EXPECT_EQ(refusal.status, CLQ_FORMAT);
    EXPECT_NE(refusal.text.find("line 2: the XML has a DOCTYPE"), std::string::npos) << refusal.text;
}

TEST(HostileTrajectories, ElementsInEachOtherWithoutEndAreRefused)
{
    std::string text = "<fcd-export>";
    for (int i = 0; i < 200000; ++i) text += "<a>";
    const Refusal refusal = refusal_of(bytes_of_text(text));
    EXPECT_EQ(refusal.status, CLQ_LIMIT);
    EXPECT_NE(refusal.text.find("more than 128 elements in each other"), std::string::npos) << refusal.text;
}

TEST(HostileTrajectories, AnElementWithMoreAttributesThanAnyHasIsRefused)
{
    for (const int count : {10000, 10001}) {
        std::string text =
            "<fcd-export><timestep time=\"0\"><person id=\"1\" x=\"0\" y=\"0\" angle=\"90\"/></timestep><a";
        for (int i = 0; i < count; ++i) text += " a" + std::to_string(i) + "=\"1\"";
        const Refusal refusal = refusal_of(bytes_of_text(text + "/></fcd-export>"));
        EXPECT_EQ(refusal.status, count == 10000 ? CLQ_OK : CLQ_LIMIT) << refusal.text;
        if (count == 10001)
            EXPECT_NE(refusal.text.find("line 1: an element with 10001 attributes; at most 10000 are read"),
                      std::string::npos)
                << refusal.text;
    }
}

TEST(HostileTrajectories, AnElementWithoutEndIsRefusedBeforeItIsReadAgainAndAgain)
{
    for (const char *begin : {"<fcd-export><timestep time=\"", "<!--", "<fcd-export "}) {
        const Refusal refusal = refusal_of(bytes_of_text(begin + std::string(9 << 20, ' ')));
        EXPECT_EQ(refusal.status, CLQ_LIMIT) << begin << ": " << refusal.text;
        EXPECT_NE(refusal.text.find("of more than 4194304 bytes"), std::string::npos) << refusal.text;
    }
}

}  // namespace
}  // namespace claque::testing

#endif
