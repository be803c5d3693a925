#include "lib/asset/trajectories/database.h"

#ifdef CLAQUE_HAS_SQLITE3
#include <sqlite3.h>
#endif

#include <algorithm>
#include <cstring>
#include <vector>

#include "lib/asset/decoders.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr char sqlite_magic[] = "SQLite format 3";  // with its 0: 16 bytes

}  // namespace

bool is_sqlite(const uint8_t *bytes, size_t size)
{
    return size >= sizeof sqlite_magic && std::memcmp(bytes, sqlite_magic, sizeof sqlite_magic) == 0;
}

#ifdef CLAQUE_HAS_SQLITE3

namespace
{

// Tables are read column by column; no function, recursion or write is needed.
int may(void *, int action, const char *name, const char *, const char *, const char *)
{
    const bool describes = action == SQLITE_PRAGMA && name && std::strcmp(name, "table_xinfo") == 0;
    return action == SQLITE_SELECT || action == SQLITE_READ || describes ? SQLITE_OK : SQLITE_DENY;
}

// Called every `steps_between` steps: damaged pages that refer to each other would be walked for ever.
constexpr int steps_between = 1000;
int count_down(void *left) { return --*static_cast<int64_t *>(left) < 0; }

}  // namespace

Database::Database(const uint8_t *bytes, size_t size) : size_(size)
{
    if (size > 20 && bytes[18] == 2)
        fail(CLQ_UNSUPPORTED, "the database is in WAL mode: change it with sqlite3 FILE 'PRAGMA journal_mode=DELETE'");
    const int opened = sqlite3_open_v2(":memory:", &handle_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY, nullptr);
    if (opened != SQLITE_OK) {
        sqlite3_close(handle_);
        throw std::bad_alloc();
    }
    try {
        sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
        sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
        sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
        sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
        sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, static_cast<int>(std::min<size_t>(size + 1000, 1000000000)));
        // READONLY: the bytes are not written.
        const int taken =
            sqlite3_deserialize(handle_, "main", const_cast<unsigned char *>(bytes), static_cast<sqlite3_int64>(size),
                                static_cast<sqlite3_int64>(size), SQLITE_DESERIALIZE_READONLY);
        // It returns SQLITE_ERROR for most failures. It has looked at no page yet, so damage cannot be the cause.
        if (taken != SQLITE_OK && (taken == SQLITE_NOMEM || sqlite3_errcode(handle_) == SQLITE_NOMEM))
            throw std::bad_alloc();
        if (taken != SQLITE_OK) refuse(taken);
        sqlite3_set_authorizer(handle_, may, nullptr);
        // A row takes some 10 steps and no fewer than 6 bytes.
        calls_left_ = 100 + static_cast<int64_t>(size) * 8 / steps_between;
        sqlite3_progress_handler(handle_, steps_between, count_down, &calls_left_);
    } catch (...) {
        sqlite3_close(handle_);
        throw;
    }
}

Database::~Database() { sqlite3_close(handle_); }

// SQLite says that it lacks memory also of lengths in damaged pages. Those it meets again, where there is room for the
// whole file once more.
bool Database::is_damaged()
{
    std::vector<uint8_t> room(size_ + 65536);
    room[0] = 1;
    const auto compare = [](void *, int, char **row, char **) {
        return int(!row[0] || std::strcmp(row[0], "ok") != 0);
    };
    sqlite3_set_authorizer(handle_, nullptr, nullptr);
    return sqlite3_exec(handle_, "PRAGMA quick_check", compare, nullptr, nullptr) != SQLITE_OK;
}

void Database::refuse(int code)
{
    if (code == SQLITE_NOMEM) {
        if (!is_damaged()) throw std::bad_alloc();
        fail(CLQ_FORMAT, "the database is damaged: its %zu bytes describe values that are longer", size_);
    }
    if (code == SQLITE_INTERRUPT) fail(CLQ_FORMAT, "the database takes more steps than its size allows: it is damaged");
    fail(CLQ_FORMAT, "the database cannot be read: %.300s", sqlite3_errmsg(handle_));
}

bool Database::has_table(const char *table)
{
    Query query(*this, "SELECT type, rootpage FROM sqlite_master WHERE name = ?1");
    query.bind(1, table);
    if (!query.next()) return false;
    const std::string type(query.text(0));
    if (type != "table") fail(CLQ_FORMAT, "'%s' is a %.20s and no table", table, type.c_str());
    if (query.whole(1) == 0) fail(CLQ_FORMAT, "'%s' is a virtual table", table);
    // Column 6 of its description is 2 or 3 for columns that are computed.
    Query columns(*this, std::string("PRAGMA table_xinfo(") + table + ")");
    while (columns.next())
        if (columns.whole(6) != 0) fail(CLQ_FORMAT, "'%s' has columns that are computed", table);
    return true;
}

bool Database::has_column(const char *table, const char *column)
{
    const int found =
        sqlite3_table_column_metadata(handle_, "main", table, column, nullptr, nullptr, nullptr, nullptr, nullptr);
    if (found == SQLITE_NOMEM) refuse(found);
    return found == SQLITE_OK;
}

Query::Query(Database &database, const std::string &sql) : database_(database)
{
    const int made = sqlite3_prepare_v2(database.handle_, sql.c_str(), -1, &statement_, nullptr);
    if (made != SQLITE_OK) database.refuse(made);
}

Query::~Query() { sqlite3_finalize(statement_); }

void Query::bind(int place, std::string_view text)
{
    const int bound =
        sqlite3_bind_text(statement_, place, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
    if (bound != SQLITE_OK) database_.refuse(bound);
}

void Query::bind(int place, int64_t number)
{
    const int bound = sqlite3_bind_int64(statement_, place, number);
    if (bound != SQLITE_OK) database_.refuse(bound);
}

bool Query::next()
{
    const int result = sqlite3_step(statement_);
    if (result != SQLITE_ROW && result != SQLITE_DONE) database_.refuse(result);
    return result == SQLITE_ROW;
}

bool Query::is_number(int column) const
{
    const int type = sqlite3_column_type(statement_, column);
    return type == SQLITE_INTEGER || type == SQLITE_FLOAT;
}

double Query::number(int column) const { return sqlite3_column_double(statement_, column); }

int64_t Query::whole(int column) const { return sqlite3_column_int64(statement_, column); }

std::string_view Query::text(int column) const
{
    const auto *text = reinterpret_cast<const char *>(sqlite3_column_text(statement_, column));
    // NULL for an empty value, and where a conversion had no memory.
    if (!text && sqlite3_errcode(database_.handle_) == SQLITE_NOMEM) database_.refuse(SQLITE_NOMEM);
    return text ? std::string_view(text, static_cast<size_t>(sqlite3_column_bytes(statement_, column)))
                : std::string_view();
}

#else

Database::Database(const uint8_t *, size_t) { refuse_without_library("a SQLite database", "libsqlite3"); }
Database::~Database() = default;
void Database::refuse(int) { fail(CLQ_UNSUPPORTED, "no database"); }
bool Database::has_table(const char *) { return false; }
bool Database::has_column(const char *, const char *) { return false; }
Query::Query(Database &database, const std::string &) : database_(database) {}
Query::~Query() = default;
void Query::bind(int, std::string_view) {}
void Query::bind(int, int64_t) {}
bool Query::next() { return false; }
bool Query::is_number(int) const { return false; }
double Query::number(int) const { return 0; }
int64_t Query::whole(int) const { return 0; }
std::string_view Query::text(int) const { return {}; }

#endif

}  // namespace claque::asset
