// Reads SQLite databases that may be anything, from memory. The schema of a file can hold expressions: views, triggers
// and functions are refused, so that reading takes time in proportion to the file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace claque::asset
{

bool is_sqlite(const uint8_t *bytes, size_t size);

// All calls throw base::Error: CLQ_FORMAT (damaged; what SQLite says), CLQ_UNSUPPORTED (built without libsqlite3; a
// database in WAL mode), and std::bad_alloc. The bytes must outlive the database.
class Database
{
public:
    Database(const uint8_t *bytes, size_t size);
    ~Database();
    Database(const Database &) = delete;
    Database &operator=(const Database &) = delete;

    bool has_table(const char *table);
    bool has_column(const char *table, const char *column);

private:
    friend class Query;
    [[noreturn]] void refuse(int code);
    bool is_damaged();
    sqlite3 *handle_ = nullptr;
    size_t size_ = 0;         // of the file
    int64_t calls_left_ = 0;  // of SQLite's progress handler
};

// The rows that a SELECT gives, one after another.
class Query
{
public:
    Query(Database &database, const std::string &sql);
    ~Query();
    Query(const Query &) = delete;
    Query &operator=(const Query &) = delete;

    void bind(int place, std::string_view text);
    void bind(int place, int64_t number);
    bool next();
    bool is_number(int column) const;  // whole or real
    double number(int column) const;
    int64_t whole(int column) const;
    std::string_view text(int column) const;  // valid until next

private:
    Database &database_;
    sqlite3_stmt *statement_ = nullptr;
};

}  // namespace claque::asset
