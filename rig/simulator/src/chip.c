/* A thin layer over simavr's C library: one ATmega328P with an AD7171 at D4/D5 and a bus master's view of its TWI.
 * simavr's structures stay on this side; the Rust side sees numbers only. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_twi.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

typedef struct chip {
	avr_t *avr;
	avr_twi_t *twi;
	elf_firmware_t firmware;
	/* The converter: bits not yet clocked out, and how many. */
	uint32_t conversion;
	int bits_left;
	int clock;
	/* Levels of the sensors' pins. */
	uint8_t levels;
	uint64_t release;
	/* The slave holds the bus's clock line until it writes TWINT. */
	int bus_held;
	/* The ignition relay. */
	int relay;
	uint64_t relay_changed;
} chip;

static avr_irq_t *pin(chip *c, int number) {
	return avr_io_getirq(c->avr, AVR_IOCTL_IOPORT_GETIRQ('D'), number);
}

/* A level from outside, against the program's pull-ups, which simavr would otherwise apply anew with every write. */
static void drive(chip *c, int number, int high) {
	avr_ioport_external_t external = {.name = 'D', .mask = 0x2c};
	c->levels = high ? c->levels | 1u << number : c->levels & ~(1u << number);
	external.value = c->levels;
	avr_ioctl(c->avr, AVR_IOCTL_IOPORT_SET_EXTERNAL('D'), &external);
	avr_raise_irq(pin(c, number), high);
}

/* The converter shows its next bit on the falling edge of the clock, and lets the line go once all have been read. */
static void on_clock(struct avr_irq_t *irq, uint32_t value, void *param) {
	chip *c = param;
	(void)irq;
	int falling = c->clock && !value;
	c->clock = value != 0;
	if (!falling || c->bits_left == 0) return;
	c->bits_left--;
	drive(c, 5, (c->conversion >> c->bits_left) & 1);
	if (c->bits_left == 0) c->release = c->avr->cycle + 64;
}

static void release_data(chip *c) {
	if (c->release && c->avr->cycle >= c->release) {
		c->release = 0;
		drive(c, 5, 1);
	}
}

/* simavr 1.6 leaves TWINT set when the program clears it by writing a one; the chip does not. */
static void on_twcr(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *param) {
	chip *c = param;
	(void)address;
	if (value & (1 << 7)) {
		avr_regbit_clear(avr, c->twi->twi.raised);
		c->bus_held = 0;
	}
}

static void on_relay(struct avr_irq_t *irq, uint32_t value, void *param) {
	chip *c = param;
	(void)irq;
	if (c->relay != (int)value) { c->relay = (int)value; c->relay_changed = c->avr->cycle; }
}

chip *chip_open(const char *path) {
	chip *c = calloc(1, sizeof(chip));
	if (!c || elf_read_firmware(path, &c->firmware)) { free(c); return NULL; }
	c->avr = avr_make_mcu_by_name("atmega328p");
	if (!c->avr) { free(c); return NULL; }
	avr_init(c->avr);
	c->avr->log = LOG_ERROR;
	c->firmware.frequency = 16000000;
	avr_load_firmware(c->avr, &c->firmware);
	c->avr->frequency = 16000000;
	for (avr_io_t *io = c->avr->io_port; io; io = io->next)
		if (!strcmp(io->kind, "twi")) c->twi = (avr_twi_t *)io;
	avr_register_io_write(c->avr, c->twi->r_twcr, on_twcr, c);
	avr_irq_register_notify(pin(c, 4), on_clock, c);
	avr_irq_register_notify(pin(c, 6), on_relay, c);
	drive(c, 2, 1);
	drive(c, 3, 1);
	drive(c, 5, 1);
	return c;
}

void chip_close(chip *c) { if (c) { avr_terminate(c->avr); free(c); } }

uint64_t chip_cycle(chip *c) { return c->avr->cycle; }

/* Runs until the cycle is reached; 0 if the processor has stopped or crashed. */
int chip_run(chip *c, uint64_t cycle) {
	while (c->avr->cycle < cycle) {
		int state = avr_run(c->avr);
		if (state == cpu_Done || state == cpu_Crashed) return 0;
		release_data(c);
	}
	return 1;
}

void chip_pin(chip *c, int number, int high) { drive(c, number, high); }

/* A conversion of 24 bits is ready: the data line goes low. */
void chip_conversion(chip *c, uint32_t bits) {
	c->conversion = bits;
	c->bits_left = 24;
	c->release = 0;
	drive(c, 5, 0);
}

int chip_relay(chip *c, uint64_t *changed) { *changed = c->relay_changed; return c->relay; }

/* The bus has reached a state: the slave's interrupt is raised with that status. */
void chip_bus_status(chip *c, uint8_t status, int data) {
	if (data >= 0) c->avr->data[c->twi->r_twdr] = (uint8_t)data;
	avr_regbit_setto_raw(c->avr, c->twi->twsr, status);
	c->bus_held = 1;
	avr_raise_interrupt(c->avr, &c->twi->twi);
}

/* Whether the slave still holds the clock line low. */
int chip_bus_held(chip *c) { return c->bus_held; }
/* Whether the slave listens at all, and to which address. */
int chip_bus_address(chip *c) {
	return avr_regbit_get(c->avr, c->twi->twen) ? c->avr->data[c->twi->r_twar] >> 1 : -1;
}
uint8_t chip_bus_data(chip *c) { return c->avr->data[c->twi->r_twdr]; }

/* Address in memory of a variable, or -1. */
int chip_variable(chip *c, const char *name) {
	for (uint32_t i = 0; i < c->firmware.symbolcount; i++)
		if (!strcmp(c->firmware.symbol[i]->symbol, name)) return (int)(c->firmware.symbol[i]->addr & 0xffff);
	return -1;
}
void chip_poke(chip *c, int address, uint8_t value) { c->avr->data[address] = value; }

/* The program hangs: interrupts off, in a loop of one instruction that jumps to itself. 0 if there is none. */
int chip_hang(chip *c) {
	for (uint32_t at = 0; at + 1 < c->firmware.flashsize; at += 2)
		if (c->avr->flash[at] == 0xff && c->avr->flash[at + 1] == 0xcf) {
			c->avr->sreg[S_I] = 0;
			c->avr->pc = at;
			return 1;
		}
	return 0;
}
