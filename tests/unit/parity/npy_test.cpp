// Reading NumPy arrays: valid, invalid and damaged files.
#include "samples/parity/npy.h"

#include <gtest/gtest.h>

namespace parity
{
namespace
{

using Bytes = std::vector<unsigned char>;

Bytes file_of(std::string header, const Bytes &values, int version = 1)
{
    header += '\n';
    Bytes out = {0x93, 'N', 'U', 'M', 'P', 'Y', static_cast<unsigned char>(version), 0};
    for (int i = 0; i < (version == 1 ? 2 : 4); ++i)
        out.push_back(static_cast<unsigned char>(header.size() >> (8 * i)));
    out.insert(out.end(), header.begin(), header.end());
    out.insert(out.end(), values.begin(), values.end());
    return out;
}

const char two_by_three[] = "{'descr': '<u2', 'fortran_order': False, 'shape': (2, 3), }      ";
const Bytes six = {1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 0, 1};

// The message of the refusal, or the array that was read.
std::string refusal(const Bytes &file, const std::string &type = "<u2")
{
    try {
        return "read, " + std::to_string(read_npy(file, "a.npy", type).bytes.size()) + " bytes";
    } catch (const Unreadable &error) {
        return error.what();
    }
}

std::string refused_header(const std::string &header) { return refusal(file_of(header, six)); }

TEST(Npy, ReadsWhatNumpyWrites)
{
    for (int version = 1; version <= 3; ++version) {
        const Array a = read_npy(file_of(two_by_three, six, version), "a.npy", "<u2");
        EXPECT_EQ(a.shape, (std::vector<size_t>{2, 3}));
        EXPECT_EQ(a.as<uint16_t>(), (std::vector<uint16_t>{1, 2, 3, 4, 5, 256}));
    }
    EXPECT_EQ(refused_header("{\"shape\": (6,), \"fortran_order\": True, \"descr\": \"<u2\"}"), "read, 12 bytes");
    EXPECT_EQ(refusal(file_of("{'descr': '<u2', 'fortran_order': False, 'shape': (0, 3), }", {})), "read, 0 bytes");
    EXPECT_EQ(refusal(file_of("{'descr': '<u2', 'fortran_order': False, 'shape': (), }", {1, 2})), "read, 2 bytes");
}

TEST(Npy, SaysWhatIsWrongWithTheType)
{
    EXPECT_EQ(refusal(file_of(two_by_three, six), "<f4"),
              "a.npy holds '<u2', and '<f4' is expected: .astype(np.float32) before saving");
    EXPECT_EQ(refused_header("{'descr': '<u2', 'fortran_order': True, 'shape': (2, 3), }"),
              "a.npy is in Fortran order: np.ascontiguousarray before saving");
    EXPECT_EQ(refused_header("{'descr': [('a', '<u2')], 'fortran_order': False, 'shape': (6,), }"),
              "a.npy is not a NumPy array: its header has no quoted string at character 10");
}

TEST(Npy, SaysWhatIsWrongWithTheSize)
{
    EXPECT_EQ(refused_header("{'descr': '<u2', 'fortran_order': False, 'shape': (7,), }"),
              "a.npy is cut short: its header promises more than its 6 values");
    EXPECT_EQ(refused_header("{'descr': '<u2', 'fortran_order': False, 'shape': (5,), }"),
              "a.npy has 12 bytes of values, and its header promises 10");
    EXPECT_EQ(
        refused_header("{'descr': '<u2', 'fortran_order': False, 'shape': (999999999999999999, 999999999999999999), }"),
        "a.npy is cut short: its header promises more than its 6 values");
    EXPECT_EQ(
        refused_header("{'descr': '<u2', 'fortran_order': False, 'shape': (99999999999999999999,), }").substr(0, 22),
        "a.npy is not a NumPy a");
}

TEST(Npy, RefusesOtherFiles)
{
    EXPECT_EQ(refusal({}), "a.npy is not a NumPy array: it does not begin as one");
    EXPECT_EQ(refusal(Bytes(100, 'x')), "a.npy is not a NumPy array: it does not begin as one");
    Bytes later = file_of(two_by_three, six);
    later[6] = 9;
    EXPECT_EQ(refusal(later), "a.npy is in version 9 of NumPy's format; 1 to 3 can be read");
    for (const char *header : {"", "{", "{}", "{'descr': '<u2'}", "{'descr': '<u2', 'fortran_order': 0, 'shape': (6,)}",
                               "{'descr': '<u2', 'fortran_order': False, 'shape': (-6,)}",
                               "{'descr': '<u2', 'fortran_order': False, 'shape': (6,)} and more",
                               "{'descr': '<u2', 'fortran_order': False, 'shape': (6,), 'more': 1}"})
        EXPECT_EQ(refused_header(header).substr(0, 22), "a.npy is not a NumPy a") << header;
}

// Every truncation and every changed byte gives a message or an array, which never exceeds the file's data.
TEST(Npy, SurvivesEveryCutAndEveryWrongByte)
{
    for (int version : {1, 2}) {
        const Bytes whole = file_of(two_by_three, six, version);
        for (size_t length = 0; length < whole.size(); ++length)
            EXPECT_NE(refusal(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))).substr(0, 4),
                      "read");
        for (size_t at = 0; at + six.size() < whole.size(); ++at)
            for (int byte = 0; byte < 256; ++byte) {
                Bytes wrong = whole;
                wrong[at] = static_cast<unsigned char>(byte);
                const std::string said = refusal(wrong);
                EXPECT_TRUE(said == "read, 12 bytes" || said.rfind("a.npy", 0) == 0) << said;
            }
    }
}

}  // namespace
}  // namespace parity
