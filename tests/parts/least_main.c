/* The least program as one of a machine's. */
int least(void);
int main(void) { return least(); }
