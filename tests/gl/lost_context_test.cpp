// Lost contexts and renderers on new ones, a thousand times: the same picture, and no memory kept.
#include "tests/gl/support/fixture.h"

namespace gltest
{
namespace
{

class Ledger : public std::pmr::memory_resource
{
public:
    size_t bytes = 0;  // allocated now

private:
    void *do_allocate(size_t size, size_t alignment) override
    {
        bytes += size;
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void *p, size_t size, size_t alignment) override
    {
        bytes -= size;
        std::pmr::new_delete_resource()->deallocate(p, size, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource &other) const noexcept override { return this == &other; }
};

class LostContexts : public GlTest
{
protected:
    void SetUp() override { make_context(32, 24); }
};

TEST_F(LostContexts, LeaveTheSamePictureAndNoMemoryAThousandTimes)
{
    constexpr int lives = 1000, lives_a_context = 25;  // creating a context takes Mesa longer than a renderer's life
    const PosedModel posed = make_posed(sheet(3, 0.2f), torture_map(16, 2, 3));
    const claque::draw::DrawList list = list_of(posed, whole_view(posed));
    Ledger ledger;
    passes::Renderer renderer(&ledger, {});
    Picture first;
    size_t forgotten = 0, in_use = 0;
    for (int life = 0; life < lives; ++life) {
        if (life % lives_a_context == 0 && life > 0) make_context(32, 24);
        ASSERT_TRUE(renderer.open(context_->get_proc_address(), context_->user()).ok());
        ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
        const Picture picture = draw(*context_, renderer, list);
        if (life == 0) first = picture, in_use = ledger.bytes;
        ASSERT_EQ(picture, first) << life;
        ASSERT_EQ(ledger.bytes, in_use) << life;
        renderer.abandon();
        if (life == 0) forgotten = ledger.bytes;
        ASSERT_EQ(ledger.bytes, forgotten) << life;
    }
    EXPECT_NE(first, Picture(first.size(), background[0])) << "nothing was drawn";
    EXPECT_LT(forgotten, in_use);
}

}  // namespace
}  // namespace gltest
